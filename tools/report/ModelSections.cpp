// A section a model: the verdict, and size against speed on each device at each resolution.
#include "report/ChartRanges.h"
#include "report/Html.h"
#include "report/ModelParts.h"
#include "report/Sections.h"
#include "report/Words.h"

#include <algorithm>
#include <set>

namespace voxc::report {
namespace {

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

/// Stages whose charts stand side by side: of one model at one resolution.
struct Group {
  std::vector<std::size_t> stages;
};

std::vector<Group> groupsOf(const Catalogue &catalogue, const std::string &model) {
  std::vector<Group> groups;
  double resolution = -1;
  for (std::size_t i = 0; i < catalogue.stages.size(); ++i) {
    const Stage &stage = catalogue.stages[i];
    if (stage.model != model)
      continue;
    if (groups.empty() || stage.resolution != resolution)
      groups.emplace_back();
    resolution = stage.resolution;
    groups.back().stages.push_back(i);
  }
  return groups;
}

/// The verdicts of a group, one for each search and one for each other set of rays, with their names where
/// there are several.
std::string verdicts(const Catalogue &catalogue, const Group &group, bool isOnly) {
  std::vector<std::string> columns;
  std::vector<std::vector<const Stage *>> stages;
  std::vector<const SearchVerdict *> searches;
  for (const std::size_t i : group.stages) {
    const Stage &stage = catalogue.stages[i];
    if (const SearchVerdict *search = catalogue.verdictOn(stage)) {
      if (std::ranges::find(searches, search) == searches.end())
        searches.push_back(search);
      continue;
    }
    const auto place = static_cast<std::size_t>(std::ranges::find(columns, stage.column) - columns.begin());
    if (place == columns.size()) {
      columns.push_back(stage.column);
      stages.emplace_back();
    }
    stages[place].push_back(&stage);
  }
  std::string text;
  for (const SearchVerdict *search : searches)
    text += searchVerdictHtml(*search);
  for (const auto &ofRays : stages) {
    const std::string verdict = verdictHtml(catalogue, ofRays);
    const bool needsTitle = !verdict.empty() && (!isOnly || stages.size() + searches.size() > 1);
    text += (needsTitle ? textTag("h3", {}, resolutionTitle(*ofRays.front())) : "") + verdict;
  }
  return text;
}

std::string figures(const Catalogue &catalogue, const Group &group, const std::vector<ChartRange> &ranges) {
  std::string text;
  for (const std::size_t i : group.stages)
    text += stageFigure(catalogue, catalogue.stages[i], ranges[i], group.stages.size() == 1);
  return text.empty() ? "" : tag("div", {{"class", "stages"}}, "\n" + text);
}

} // namespace

std::string modelSections(const Catalogue &catalogue, const Pictures &pictures, const ModelNotes &notes) {
  const std::vector<ChartRange> ranges = chartRanges(catalogue);
  std::string text;
  for (std::size_t model = 0; model < catalogue.models.size(); ++model) {
    const std::string &name = catalogue.models[model];
    const std::vector<Group> groups = groupsOf(catalogue, name);
    std::string answers, charts;
    for (const Group &group : groups) {
      answers += verdicts(catalogue, group, groups.size() == 1);
      charts += figures(catalogue, group, ranges);
    }
    if (!charts.empty())
      text += fill("section/model.html", {{"id", anchor(model)},
                                          {"name", escaped(name)},
                                          {"verdict", answers},
                                          {"picture", picture(pictures, name)},
                                          {"note", note(notes, name)},
                                          {"facts", facts(catalogue, name)},
                                          {"legend", legend(catalogue, name)},
                                          {"figures", charts}});
  }
  return text;
}

} // namespace voxc::report
