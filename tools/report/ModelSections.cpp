// A section a model: its picture, its facts, and size against speed on each device at each resolution.
#include "report/FrontierChart.h"
#include "report/Html.h"
#include "report/Sections.h"
#include "report/Words.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace voxc::report {
namespace {

Chart makeChart(const Catalogue &catalogue, const Stage &stage) {
  Chart chart{stage.model + ", " + stageTitle(stage) + ": size against speed", speedUnit(stage.hasClock), {}};
  for (const std::size_t i : stage.entries) {
    const Entry &entry = catalogue.entries[i];
    if (entry.hasPoint())
      chart.points.push_back({*entry.bytes, entry.speed->median, entry.look.family, entry.format,
                              entry.onFrontier, entry.errors && entry.errors->sum() > 0, entry.look.name,
                              pointNote(entry), "#" + rowId(catalogue, entry)});
  }
  std::ranges::sort(chart.points, {}, [](const ChartPoint &point) {
    return std::tuple(point.bytes, point.speed, point.format);
  });
  return chart;
}

std::string failedNames(const Catalogue &catalogue, const Stage &stage) {
  std::string names;
  for (const std::size_t i : stage.entries)
    if (const Entry &entry = catalogue.entries[i]; !entry.cell->isMeasured())
      names += (names.empty() ? "" : ", ") + entry.look.name;
  return names;
}

/// The frontier in words, for labels may crowd: "On the frontier, small ones first: G(9), 12.9 MiB, 1.12;
/// ...".
std::string frontierWords(const Chart &chart) {
  std::string items;
  for (const ChartPoint &point : chart.points)
    if (point.onFrontier)
      items += (items.empty() ? "" : "; ") + textTag("b", {}, point.label) + " " + bytesText(point.bytes) +
               ", " + numberText(point.speed);
  return "On the frontier, small ones first: " + items + ".";
}

/// What stands below a chart: what was wrong, what failed, and what is elsewhere.
std::string remarks(const Catalogue &catalogue, const Stage &stage) {
  std::string text = "Errors: " + errorSummary(catalogue, stage.entries) + ".";
  const auto unsteady = std::ranges::count_if(stage.entries, [&](std::size_t i) {
    return catalogue.entries[i].hasPoint() && !catalogue.entries[i].isSteady;
  });
  if (unsteady > 0)
    text += " Not steady: " + plural(static_cast<std::size_t>(unsteady), "speed") + ".";
  if (const std::string failed = failedNames(catalogue, stage); !failed.empty())
    text += " Failed: " + failed + ".";
  if (stage.otherPasses > 0)
    text += " With other passes: " + plural(stage.otherPasses, "cell") + ", in the table.";
  return text;
}

std::string figure(const Catalogue &catalogue, const Stage &stage) {
  const Chart chart = makeChart(catalogue, stage);
  if (chart.points.empty())
    return {};
  const std::string caption =
      textTag("b", {}, stageTitle(stage)) + " " + textTag("span", {}, stageConditions(stage));
  return tag("figure", {{"class", "stage"}},
             tag("figcaption", {}, caption) + toSvg(chart) +
                 tag("p", {{"class", "remarks"}}, frontierWords(chart)) +
                 textTag("p", {{"class", "remarks"}}, remarks(catalogue, stage))) +
         "\n";
}

/// "2048 × 857 × 1260 voxels, 12,345,678 of them not empty"; nothing if the size is not known.
std::string sizeWords(const tool::bench::ModelPart &model) {
  if (!model.size)
    return {};
  std::string words;
  for (const std::uint64_t side : *model.size)
    words += (words.empty() ? "" : " × ") + std::to_string(side);
  return words + " voxels" +
         (model.voxels ? ", " + countText(double(*model.voxels)) + " of them not empty" : "");
}

/// The sizes of a model, a line a resolution.
std::string facts(const Catalogue &catalogue, const std::string &name) {
  std::vector<std::string> lines;
  for (const Stage &stage : catalogue.stages)
    for (const std::size_t i : stage.entries) {
      const tool::bench::ModelPart &model = catalogue.entries[i].cell->model;
      if (const std::string words = sizeWords(model);
          model.name == name && !words.empty() && std::ranges::find(lines, words) == lines.end())
        lines.push_back(words);
    }
  std::string text;
  for (const std::string &line : lines)
    text += textTag("li", {}, line);
  return text.empty() ? "" : tag("ul", {{"class", "facts"}}, text);
}

/// The marks of the families that a model's charts show.
std::string legend(const Catalogue &catalogue, const std::string &model) {
  std::set<std::size_t> used;
  for (const Entry &entry : catalogue.entries)
    if (entry.hasPoint() && entry.cell->model.name == model)
      used.insert(entry.look.family);
  std::string items;
  for (const std::size_t family : used)
    items += tag("li", {}, legendMark(family) + escaped(families()[family]));
  return tag("ul", {{"class", "legend"}, {"aria-label", "Marks of the families of formats"}}, items);
}

std::string anchor(std::size_t model) { return "model-" + std::to_string(model + 1); }

std::string picture(const Pictures &pictures, const std::string &model) {
  const auto found = pictures.find(model);
  return found == pictures.end()
             ? ""
             : tag("img", {{"class", "portrait"}, {"src", found->second}, {"alt", "A picture of " + model}},
                   "");
}

std::string note(const ModelNotes &notes, const std::string &model) {
  const auto found = notes.find(model);
  return found == notes.end() ? "" : textTag("p", {{"class", "note"}}, found->second);
}

} // namespace

std::string modelSections(const Catalogue &catalogue, const Pictures &pictures, const ModelNotes &notes) {
  std::string text;
  for (std::size_t model = 0; model < catalogue.models.size(); ++model) {
    const std::string &name = catalogue.models[model];
    std::string figures;
    for (const Stage &stage : catalogue.stages)
      if (stage.model == name)
        figures += figure(catalogue, stage);
    if (!figures.empty())
      text += fill("section/model.html", {{"id", anchor(model)},
                                          {"name", escaped(name)},
                                          {"picture", picture(pictures, name)},
                                          {"note", note(notes, name)},
                                          {"facts", facts(catalogue, name)},
                                          {"legend", legend(catalogue, name)},
                                          {"figures", figures}});
  }
  return text;
}

} // namespace voxc::report
