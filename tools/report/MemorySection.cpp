// The largest memory of building, by format and model.
#include "report/BarTable.h"
#include "report/Html.h"
#include "report/Sections.h"
#include "report/Words.h"

#include <map>

namespace voxc::report {
namespace {

/// A table a resolution, large ones first.
using Tables = std::map<double, BarTable, std::greater<>>;

void addPeak(Tables &tables, const Entry &entry) {
  BarTable &table = tables[entry.resolution];
  table.caption = sideText(entry.resolution);
  const double bytes = *entry.peakBytes;
  Bar &bar = table.bars[{table.row(entry.look.name), table.column(entry.cell->model.name)}];
  if (bytes >= bar.value)
    bar = {bytes, bytesText(bytes), wholeName(entry)};
}

/// Marks the largest of each column.
void markLargest(BarTable &table) {
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    Bar *largest = nullptr;
    for (auto &[place, bar] : table.bars)
      if (place.second == column && (!largest || bar.value > largest->value))
        largest = &bar;
    if (largest)
      largest->tone = Tone::Worse;
  }
}

} // namespace

std::string memorySection(const Catalogue &catalogue) {
  Tables tables;
  for (const Entry &entry : catalogue.entries)
    if (entry.peakBytes)
      addPeak(tables, entry);
  std::string content;
  for (auto &[resolution, table] : tables) {
    markLargest(table);
    content += toHtml(table);
  }
  return content.empty() ? "" : fill("section/memory.html", {{"content", content}});
}

} // namespace voxc::report
