// Names and families of formats.
#include "report/FormatLook.h"

#include "voxc/IR/Format.h"

#include <algorithm>
#include <array>

namespace voxc::report {
namespace {

bool isTree(const Level &level) { return level.kind->isTree(); }
bool isDag(const Level &level) { return level.kind->letter == 'G'; }
bool hasDistances(const Level &level) { return level.parameter(ParameterRole::Reach) > 0; }

bool always(const Format &) { return true; }
bool isGrids(const Format &format) { return std::ranges::none_of(format.levels, isTree); }
bool isTrees(const Format &format) { return std::ranges::all_of(format.levels, isTree); }
bool isGridOverTree(const Format &format) {
  return !isTree(format.levels.front()) && isTree(format.levels.back());
}
bool isDistancesOverTree(const Format &format) {
  return isGridOverTree(format) && std::ranges::any_of(format.levels, hasDistances);
}
bool isGridOverDag(const Format &format) { return isGridOverTree(format) && isDag(format.levels.back()); }

/// A format belongs to the first family whose condition holds.
constexpr std::array<bool (*)(const Format &), 6> kConditions = {
    isDistancesOverTree, isGridOverDag, isGridOverTree, isTrees, isGrids, always};
constexpr std::array<std::string_view, 6> kFamilies = {
    "D over a tree", "R over a DAG (G)", "R over an octree (S)", "trees alone", "grids alone", "others"};

/// "4³" for cubic sizes, "4, 4, 5" for others, and the reach of distances.
std::string parametersText(const Level &level) {
  std::string text;
  const auto append = [&](const std::string &part) { text += (text.empty() ? "" : ", ") + part; };
  if (!isTree(level) && level.isCubic())
    append(std::to_string(level.parameter(ParameterRole::Width)) + "³");
  for (std::size_t i = 0; i < level.parameters.size(); ++i) {
    if (level.kind->parameters[i].usual == level.parameters[i])
      continue; // As it is when it is not written.
    if (isTree(level) || !level.kind->parameters[i].isSize() || !level.isCubic())
      append(std::to_string(level.parameters[i]));
  }
  return text;
}

} // namespace

FormatLook lookOf(const std::string &text) {
  const Expected<Format> format = parseFormat(text);
  if (!format || format->levels.empty())
    return {text, kFamilies.size() - 1, {}};
  FormatLook look;
  for (const Level &level : format->levels) {
    look.levels.push_back(std::string(1, level.kind->letter) + "(" + parametersText(level) + ")");
    look.name += (look.name.empty() ? "" : " ") + look.levels.back();
  }
  look.family = static_cast<std::size_t>(
      std::ranges::find_if(kConditions, [&](const auto &condition) { return condition(*format); }) -
      kConditions.begin());
  return look;
}

std::span<const std::string_view> families() { return kFamilies; }

} // namespace voxc::report
