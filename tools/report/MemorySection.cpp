// The largest memory of building, by format and model.
#include "report/BarTable.h"
#include "report/Html.h"
#include "report/Sections.h"
#include "report/Words.h"

#include <algorithm>
#include <functional>
#include <limits>
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

/// The least and the most of a table.
std::pair<double, double> extremes(const BarTable &table) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const auto &[place, bar] : table.bars) {
    least = std::min(least, bar.value);
    most = std::max(most, bar.value);
  }
  return {least, most};
}

/// Marks the largest of each column, if it stands out.
void markLargest(BarTable &table) {
  constexpr double kStandsOut = 1.5; // Times the next.
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    Bar *largest = nullptr;
    double next = 0;
    for (auto &[place, bar] : table.bars)
      if (place.second == column && (!largest || bar.value > largest->value)) {
        next = largest ? largest->value : 0;
        largest = &bar;
      } else if (place.second == column) {
        next = std::max(next, bar.value);
      }
    if (largest && next > 0 && largest->value >= kStandsOut * next)
      largest->tone = Tone::Worse;
  }
}

/// The rows that need most, where there are too many to be looked at.
BarTable largestRows(const BarTable &table) {
  constexpr std::size_t kMostRows = 40, kRows = 15;
  if (table.rows.size() <= kMostRows)
    return table;
  std::vector<std::pair<double, std::size_t>> order(table.rows.size());
  for (const auto &[place, bar] : table.bars)
    order[place.first] = std::max(order[place.first], {bar.value, place.first});
  std::ranges::sort(order, std::greater());
  BarTable largest{table.caption + ", the " + std::to_string(kRows) + " of " +
                       std::to_string(table.rows.size()) + " formats that need most",
                   table.columns,
                   {},
                   {},
                   table.reference};
  for (std::size_t i = 0; i < kRows; ++i)
    for (std::size_t column = 0; column < table.columns.size(); ++column)
      if (const auto bar = table.bars.find({order[i].second, column}); bar != table.bars.end())
        largest.bars[{largest.row(table.rows[order[i].second]), column}] = bar->second;
  return largest;
}

/// A sentence where all need about the same, for equal bars say nothing; else the bars.
std::string tableHtml(BarTable table) {
  constexpr double kAboutTheSame = 1.25;
  const auto [least, most] = extremes(table);
  if (most <= kAboutTheSame * least)
    return tag("p", {},
               textTag("b", {}, table.caption) + ": all of " + plural(table.rows.size(), "format") +
                   " need about the same, " + bytesText(least) + " to " + bytesText(most) + ".");
  markLargest(table);
  return toHtml(largestRows(table));
}

} // namespace

std::string memorySection(const Catalogue &catalogue) {
  Tables tables;
  for (const Entry &entry : catalogue.entries)
    if (entry.peakBytes)
      addPeak(tables, entry);
  std::string content;
  for (const auto &[resolution, table] : tables)
    content += tableHtml(table);
  return content.empty() ? "" : fill("section/memory.html", {{"content", content}});
}

} // namespace voxc::report
