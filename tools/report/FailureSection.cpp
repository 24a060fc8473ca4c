// Cells that failed, and why.
#include "report/Html.h"
#include "report/Sections.h"
#include "report/Words.h"

namespace voxc::report {
namespace {

std::string reasonText(const tool::bench::Failure &failure) {
  const std::string reason = failure.reason.empty() ? "no reason was recorded" : failure.reason;
  return reason + (failure.words ? " (it reached " + countText(double(*failure.words)) + " words)" : "");
}

std::string row(const Entry &entry) {
  const tool::bench::Failure &failure = *entry.cell->failure;
  return tag("tr", {},
             textTag("th", {{"scope", "row"}}, entry.look.name) + textTag("td", {}, entry.column) +
                 textTag("td", {}, entry.passes) + textTag("td", {}, entry.device) +
                 textTag("td", {}, failure.stage) +
                 textTag("td", {{"class", "words"}}, reasonText(failure))) +
         "\n";
}

} // namespace

std::string failureSection(const Catalogue &catalogue) {
  std::string rows;
  for (const Entry &entry : catalogue.entries)
    if (!entry.cell->isMeasured())
      rows += row(entry);
  return rows.empty() ? "" : fill("section/failures.html", {{"rows", rows}});
}

} // namespace voxc::report
