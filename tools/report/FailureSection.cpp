// Cells that failed, and why.
#include "report/Html.h"
#include "report/Sections.h"

#include <algorithm>
#include <vector>

namespace voxc::report {
namespace {

std::string reasonText(const tool::bench::Failure &failure) {
  const std::string reason = failure.reason.empty() ? "no reason was recorded" : failure.reason;
  return reason + (failure.words ? " (it reached " + countText(double(*failure.words)) + " words)" : "");
}

/// The cells of a row without their devices: of what fails before it is traced there are as many as devices.
std::string cellsOf(const Entry &entry) {
  const tool::bench::Failure &failure = *entry.cell->failure;
  return textTag("th", {{"scope", "row"}}, entry.look.name) + textTag("td", {}, entry.column) +
         textTag("td", {}, passList(entry.cell->format.passes)) + textTag("td", {}, failure.stage) +
         textTag("td", {{"class", "words"}}, reasonText(failure));
}

/// A row with the devices that it is true of.
struct Row {
  std::string cells, devices;
};

std::vector<Row> makeRows(const Catalogue &catalogue) {
  std::vector<Row> rows;
  for (const Entry &entry : catalogue.entries) {
    if (entry.cell->isMeasured())
      continue;
    const std::string cells = cellsOf(entry);
    auto row = std::ranges::find(rows, cells, &Row::cells);
    if (row == rows.end())
      row = rows.insert(rows.end(), {cells, ""});
    row->devices += (row->devices.empty() ? "" : ", ") + entry.device;
  }
  return rows;
}

} // namespace

std::string failureSection(const Catalogue &catalogue) {
  std::string html;
  for (const Row &row : makeRows(catalogue))
    html += tag("tr", {}, row.cells + textTag("td", {{"class", "words"}}, row.devices)) + "\n";
  return html.empty() ? "" : fill("section/failures.html", {{"rows", html}});
}

} // namespace voxc::report
