// The table below a chart: the formats on the frontier, and what makes them small or fast.
#include "report/Html.h"
#include "report/ModelParts.h"
#include "report/Words.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace voxc::report {
namespace {

constexpr double kWordBytes = 4;

std::string figureText(Figure value) { return value ? numberText(*value) : ""; }

/// What a ray costs; a column is left out if no leader has a figure for it.
struct Column {
  const char *heading;
  const char *meaning;
  Figure (*value)(const Entry &);
};

constexpr Column kColumns[] = {
    {"Lookups", "Lookups a ray, on the mean", [](const Entry &e) { return e.cell->work.stepsPerRay; }},
    {"Words", "Words read a ray, on the mean", [](const Entry &e) { return e.cell->work.wordsPerRay; }},
    {"Lines", "Different cache lines a ray, as a search foretold",
     [](const Entry &e) { return e.cell->predicted ? e.cell->predicted->lines : Figure(); }},
    {"Foretold", "The speed that a search foretold",
     [](const Entry &e) { return e.cell->predicted ? e.cell->predicted->mraysPerS : Figure(); }},
};

/// The words of each level, if there are as many as levels.
std::vector<double> levelBytes(const Entry &entry) {
  const auto &words = entry.cell->volume.levelWords;
  if (!words || words->size() != entry.look.levels.size())
    return {};
  std::vector<double> bytes;
  for (const std::uint64_t count : *words)
    bytes.push_back(kWordBytes * double(count));
  return bytes;
}

/// A bar as long as the size against the largest leader's, on the whole width, in a piece a level; and the
/// same in words.
std::string levelBar(const Entry &entry, double mostBytes) {
  const std::vector<double> bytes = levelBytes(entry);
  const double sum = std::accumulate(bytes.begin(), bytes.end(), 0.0);
  if (sum <= 0)
    return {};
  std::string pieces, words;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::string width = "width:" + plot::coordinate(100 * std::min(1.0, bytes[i] / mostBytes)) + "%";
    pieces += tag("i", {{"style", width}}, "");
    words += (words.empty() ? "" : " · ") + entry.look.levels[i] + " " + bytesText(bytes[i]);
  }
  return tag("div", {{"class", "levels-bar"}, {"aria-hidden", "true"}}, pieces) + textTag("small", {}, words);
}

std::vector<const Entry *> leadersOf(const Catalogue &catalogue, const Stage &stage) {
  std::vector<const Entry *> leaders;
  for (const std::size_t i : stage.entries)
    if (catalogue.entries[i].isLeading())
      leaders.push_back(&catalogue.entries[i]);
  std::ranges::sort(leaders, {}, [](const Entry *entry) { return *entry->bytes; });
  return leaders;
}

std::string speedCell(const Entry &entry) {
  const std::string rounds =
      numberText(entry.speed->min) + " to " + numberText(entry.speed->max) + " in " +
      (entry.cell->speed.rounds ? plural(static_cast<std::size_t>(*entry.cell->speed.rounds), "round")
                                : "its rounds");
  return tag("td", {{"class", "n"}, {"title", rounds}},
             escaped(numberText(entry.speed->median)) +
                 textTag("small", {}, "± " + percentText(entry.speed->spread / 2)));
}

} // namespace

std::string leaderTable(const Catalogue &catalogue, const Stage &stage) {
  const std::vector<const Entry *> leaders = leadersOf(catalogue, stage);
  std::vector<const Column *> columns;
  for (const Column &column : kColumns)
    if (std::ranges::any_of(leaders, [&](const Entry *entry) { return column.value(*entry).has_value(); }))
      columns.push_back(&column);
  std::string head = textTag("th", {{"scope", "col"}}, "On the frontier") +
                     textTag("th", {{"scope", "col"}, {"class", "n"}}, "Size") +
                     textTag("th", {{"scope", "col"}, {"class", "n"}}, "Speed");
  for (const Column *column : columns)
    head += textTag("th", {{"scope", "col"}, {"class", "n"}, {"title", column->meaning}}, column->heading);
  std::string body;
  for (const Entry *leader : leaders) {
    std::string row =
        tag("th", {{"scope", "row"}},
            textTag("span", {{"class", "name"}}, leader->name) + levelBar(*leader, *leaders.back()->bytes)) +
        textTag("td", {{"class", "n"}}, bytesText(*leader->bytes)) + speedCell(*leader);
    for (const Column *column : columns)
      row += textTag("td", {{"class", "n"}}, figureText(column->value(*leader)));
    body += tag("tr", {}, row) + "\n";
  }
  constexpr std::size_t kMany = 3;
  const std::string style = columns.size() >= kMany ? "leaders many" : "leaders";
  return tag("div", {{"class", "scroll"}},
             tag("table", {{"class", style}, {"style", "--figures:" + std::to_string(columns.size() + 2)}},
                 tag("thead", {}, tag("tr", {}, head)) + tag("tbody", {}, body)));
}

} // namespace voxc::report
