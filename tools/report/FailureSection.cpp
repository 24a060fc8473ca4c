// Cells that failed, and why.
#include "report/Html.h"
#include "report/Sections.h"
#include "report/Words.h"

namespace voxc::report {
namespace {

std::string row(const Entry &entry) {
  const Cell &cell = *entry.cell;
  std::string reason = cell.failure.reason.empty() ? "no reason was recorded" : cell.failure.reason;
  if (cell.failure.words)
    reason += " (it reached " + countText(*cell.failure.words) + " words)";
  return tag("tr", {},
             textTag("th", {{"scope", "row"}}, entry.look.name) + textTag("td", {}, entry.column) +
                 textTag("td", {}, entry.passes) + textTag("td", {}, entry.device) +
                 textTag("td", {}, cell.failure.stage) + textTag("td", {{"class", "words"}}, reason)) +
         "\n";
}

} // namespace

std::string failureSection(const Catalogue &catalogue) {
  std::string rows;
  for (const Entry &entry : catalogue.entries)
    if (!entry.cell->measured)
      rows += row(entry);
  return rows.empty() ? "" : fill("section/failures.html", {{"rows", rows}});
}

} // namespace voxc::report
