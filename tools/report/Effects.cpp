// What one thing changes, all else being the same: whole-level-dedup, restart-sv, unroll-sv, exact steps.
#include "report/BarTable.h"
#include "report/Html.h"
#include "report/Pairs.h"
#include "report/Sections.h"
#include "report/Words.h"

#include <algorithm>
#include <span>

namespace voxc::report {
namespace {

/// "1.83×".
std::string timesText(double ratio) { return numberText(ratio) + "×"; }

struct Extremes {
  double least = 0, most = 0;
  std::string leastName, mostName;
};

Extremes extremes(const std::vector<BarTable> &tables) {
  Extremes found;
  for (const BarTable &table : tables)
    for (const auto &[place, bar] : table.bars) {
      const std::string name = table.rows[place.first] + " of " + table.columns[place.second];
      if (found.most == 0 || bar.value > found.most)
        found.most = bar.value, found.mostName = name;
      if (found.least == 0 || bar.value < found.least)
        found.least = bar.value, found.leastName = name;
    }
  return found;
}

std::string section(std::string_view path, const std::vector<BarTable> &tables) {
  std::string content;
  for (const BarTable &table : tables)
    content += toHtml(table);
  if (content.empty())
    return {};
  const Extremes found = extremes(tables);
  return fill(path, {{"content", content},
                     {"most", timesText(found.most)},
                     {"most_name", escaped(found.mostName)},
                     {"least", timesText(found.least)},
                     {"least_name", escaped(found.leastName)}});
}

/// The table of a device's captions, made when it is first asked for.
BarTable &tableFor(std::vector<BarTable> &tables, const std::string &caption) {
  const auto found = std::ranges::find(tables, caption, &BarTable::caption);
  if (found != tables.end())
    return *found;
  tables.push_back({caption, {}, {}, {}, 1});
  return tables.back();
}

std::string speedNote(const Pair &pair, const char *with, const char *without) {
  return std::string(with) + ": " + speedWords(*pair.with) + "; " + errorWords(*pair.with) + "\n" + without +
         ": " + speedWords(*pair.without) + "; " + errorWords(*pair.without);
}

Tone toneOf(const Pair &pair) {
  if (isAsFast(pair))
    return Tone::Equal;
  return speedUp(pair) > 1 ? Tone::Better : Tone::Worse;
}

/// The rays that either of the two got wrong, where there are any.
std::string errorMark(const Pair &pair) {
  double sum = 0;
  for (const Entry *entry : {pair.with, pair.without})
    sum += entry->errors ? entry->errors->sum() : 0;
  return sum > 0 ? ", " + plural(static_cast<std::size_t>(sum), "error") : "";
}

/// Speeds of pairs, a table a device.
std::vector<BarTable> speedTables(const std::vector<Pair> &pairs, const char *with, const char *without) {
  std::vector<BarTable> tables;
  for (const Pair &pair : pairs) {
    const double ratio = speedUp(pair);
    if (ratio <= 0)
      continue;
    BarTable &table = tableFor(tables, "On " + pair.with->device);
    const std::size_t row = table.row(pair.with->look.name), column = table.column(pair.with->column);
    const std::string words = timesText(ratio) + (isAsFast(pair) ? " =" : "") + errorMark(pair);
    table.bars.try_emplace({row, column}, Bar{ratio, words, speedNote(pair, with, without), toneOf(pair)});
  }
  return tables;
}

} // namespace

std::string dedupSection(const Catalogue &catalogue) {
  std::vector<BarTable> tables;
  for (const Pair &pair : pairsByPass(catalogue, "whole-level-dedup")) {
    const double ratio = shrinkage(pair);
    if (ratio <= 0)
      continue;
    BarTable &table = tableFor(tables, "");
    const std::size_t row = table.row(pair.with->look.name),
                      column = table.column(pair.with->cell->model.name);
    const std::string note =
        bytesText(*pair.without->bytes) + " without, " + bytesText(*pair.with->bytes) + " with";
    table.bars.try_emplace({row, column},
                           Bar{ratio, timesText(ratio), note, ratio > 1 ? Tone::Better : Tone::Equal});
  }
  return section("section/dedup.html", tables);
}

std::string restartSection(const Catalogue &catalogue) {
  return section("section/restart.html",
                 speedTables(pairsByPass(catalogue, "restart-sv"), "restart", "stack"));
}

std::string unrollSection(const Catalogue &catalogue) {
  return section("section/unroll.html",
                 speedTables(pairsByPass(catalogue, "unroll-sv"), "unrolled", "stack"));
}

std::string precisionSection(const Catalogue &catalogue) {
  return section("section/precision.html", speedTables(pairsByPrecision(catalogue), "fast", "exact"));
}

} // namespace voxc::report
