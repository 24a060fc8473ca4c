// The figure of a stage.
#include "report/Html.h"
#include "report/ModelParts.h"
#include "report/Sections.h"
#include "report/Words.h"

#include <algorithm>
#include <tuple>

namespace voxc::report {
namespace {

/// Longer lists are for the table.
constexpr std::size_t kMostNames = 6;

ChartPoint makePoint(const Catalogue &catalogue, const Entry &entry) {
  const Entry &rival = catalogue.entries[entry.standing.rival];
  return {.bytes = *entry.bytes,
          .speed = *entry.speed,
          .family = entry.look.family,
          .variant = entry.variant,
          .place = entry.standing.place,
          .share = entry.speed->median / rival.speed->median,
          .hasErrors = entry.errors && entry.errors->sum() > 0,
          .label = entry.name,
          .note = pointNote(catalogue, entry),
          .target = "#" + rowId(catalogue, entry)};
}

Chart makeChart(const Catalogue &catalogue, const Stage &stage, const ChartRange &range, bool isAlone) {
  Chart chart{stage.model + ", " + stageTitle(stage) + ": size against speed",
              speedUnit(stage.hasClock),
              isAlone,
              range,
              {}};
  for (const std::size_t i : stage.entries)
    if (catalogue.entries[i].hasPoint())
      chart.points.push_back(makePoint(catalogue, catalogue.entries[i]));
  std::ranges::sort(chart.points, {}, [](const ChartPoint &point) {
    return std::tuple(point.bytes, point.speed.median, point.variant);
  });
  return chart;
}

/// " Not steady: G(8), G(9) and 3 more.", of the entries that are so; nothing if none is.
template <typename Condition>
std::string listWords(const Catalogue &catalogue, const Stage &stage, const char *what, Condition isSo) {
  std::vector<const Entry *> entries;
  for (const std::size_t i : stage.entries)
    if (isSo(catalogue.entries[i]))
      entries.push_back(&catalogue.entries[i]);
  return entries.empty() ? "" : std::string(" ") + what + ": " + nameList(entries, kMostNames) + ".";
}

/// What stands below a chart: what is as good, what was wrong, what failed.
std::string remarks(const Catalogue &catalogue, const Stage &stage) {
  std::string text =
      listWords(catalogue, stage, "As good as the frontier", [](const Entry &e) { return e.isAsGood(); });
  text += " Errors: " + escaped(errorSummary(catalogue, stage.entries)) + ".";
  text +=
      listWords(catalogue, stage, "Not steady", [](const Entry &e) { return e.hasPoint() && !e.isSteady; });
  return text + listWords(catalogue, stage, "Failed", [](const Entry &e) { return !e.cell->isMeasured(); });
}

} // namespace

std::string stageFigure(const Catalogue &catalogue, const Stage &stage, const ChartRange &range,
                        bool isAlone) {
  const Chart chart = makeChart(catalogue, stage, range, isAlone);
  if (chart.points.empty())
    return {};
  const std::string caption =
      textTag("b", {}, stageTitle(stage)) + " " + textTag("span", {}, stageConditions(catalogue, stage));
  return tag("figure", {{"class", "stage"}},
             tag("figcaption", {}, caption) + toSvg(chart) + leaderTable(catalogue, stage) +
                 tag("p", {{"class", "remarks"}}, remarks(catalogue, stage))) +
         "\n";
}

} // namespace voxc::report
