// Printing a plan as construct.cpp: one function a level, the last level first.
#include "Names.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <vector>

namespace voxc {
namespace {

std::string treeConstants(const Stratum &stratum, const std::string &prefix) {
  const auto number = [&](const char *name, int value) {
    return "constexpr int " + prefix + name + " = " + std::to_string(value) + ";\n";
  };
  return number("LAYERS", stratum.depth) + number("BRANCH", stratum.log2Shape.x) +
         number("CHILDREN", 1 << stratum.log2Children()) + number("LOG2_CELL", stratum.log2Cell);
}

std::string gridConstants(const Stratum &stratum, bool holdsVoxels, const std::string &prefix) {
  const Int3 size = stratum.log2Shape;
  std::string lines = "constexpr GridShape " + prefix + "SHAPE = {" + std::to_string(size.x) + ", " +
                      std::to_string(size.y) + ", " + std::to_string(size.z) + ", " +
                      std::to_string(stratum.log2Cell) + ", " + (holdsVoxels ? "true" : "false") + "};\n";
  if (const Distances *const distances = stratum.distances())
    lines += "constexpr uint32_t " + prefix + "REACH = " + std::to_string(distances->reach) + ";\n";
  return lines;
}

std::string constants(const Plan &plan, std::size_t index) {
  const Stratum &stratum = plan.layout.strata[index];
  const std::string prefix = "LEVEL_" + std::to_string(index + 1) + "_";
  return stratum.isGrid() ? gridConstants(stratum, plan.layout.holdsVoxels(index), prefix)
                          : treeConstants(stratum, prefix);
}

/// The runtime files of a level's construction, in the order in which they are printed.
std::vector<std::string> filesOf(const Plan &plan, std::size_t index) {
  const Stratum &stratum = plan.layout.strata[index];
  std::vector<std::string> files;
  if (const Distances *const distances = stratum.distances())
    files.push_back("distances/" + std::string(toString(distances->metric)) + ".cpp");
  for (const std::string_view file : stratum.slots->construction(stratum))
    files.push_back("slots/" + std::string(file) + ".cpp");
  if (!stratum.slots->root) {
    files.emplace_back("part/grid.cpp");
    return files;
  }
  files.insert(files.end(), {"descent/join.cpp",
                             plan.constructions[index].bricks ? "descent/voxels.cpp" : "descent/cells.cpp",
                             "root/" + std::string(stratum.slots->root(stratum)) + ".cpp", "part/tree.cpp"});
  return files;
}

std::string functions(const Plan &plan, std::size_t index) {
  std::string lines;
  for (const std::string &file : filesOf(plan, index))
    lines += "\n" + fillFile(constructFiles(), file, stratumNames(plan, index));
  return lines;
}

/// Which level an aligned cube belongs to when it is built apart: the highest with smaller cells.
std::string partChoice(const Plan &plan) {
  std::string lines;
  for (std::size_t i = 0; i < plan.layout.strata.size(); ++i) {
    const std::string log2Cell = std::to_string(plan.layout.strata[i].log2Cell);
    lines += plan.layout.holdsVoxels(i) ? "  " : "  if (log2_side > " + log2Cell + ")\n    return ";
    lines += "construct_level_" + std::to_string(i + 1) + "_part(build, {x, y, z}, log2_side);\n";
  }
  return lines;
}

} // namespace

std::string emitConstruct(const Plan &plan) {
  TemplateNames names = planNames(plan);
  std::string levels;
  if (std::ranges::any_of(plan.layout.strata, reportsBall)) // Once for all that measure them.
    levels += "\n" + fillFile(constructFiles(), "distances/plane.cpp", names);
  for (std::size_t i = plan.layout.strata.size(); i-- > 0;)
    levels += levelComment(plan, i) + constants(plan, i) + functions(plan, i);
  names.holes["LEVELS"] = levels;
  names.holes["PARTS"] = partChoice(plan);
  return fillFile(constructFiles(), "construct.cpp", names);
}

} // namespace voxc
