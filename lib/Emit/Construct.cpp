// Printing a plan as construct.cpp: one function a level, the last level first.
#include "ConstructLevel.h"
#include "Names.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Layout/SlotKind.h"

#include <vector>

namespace voxc {
namespace {

/// The runtime files of a level's construction, in the order in which they are printed.
std::vector<std::string> filesOf(const Plan &plan, std::size_t index) {
  const Stratum &stratum = plan.layout.strata[index];
  const SlotKind &kind = *stratum.slots;
  std::vector<std::string> files;
  if (const Distances *const distances = stratum.distances())
    files.push_back("distances/" + std::string(toString(distances->metric)));
  for (const std::string_view file : kind.writing(stratum))
    files.push_back("slots/" + std::string(file));
  if (!kind.root) {
    files.insert(files.end(), {"slots/" + std::string(kind.construct), "part/grid"});
    return files;
  }
  files.insert(files.end(),
               {"descent/join", plan.constructions[index].bricks ? "descent/voxels" : "descent/cells",
                "root/" + std::string(kind.root(stratum)), "descent/tree", "part/tree"});
  return files;
}

std::string functions(const Plan &plan, std::size_t index) {
  std::string lines;
  for (const std::string &file : filesOf(plan, index))
    lines += constructLeaf(plan, index, file);
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
  std::string levels = constructPlanes(plan);
  for (std::size_t i = plan.layout.strata.size(); i-- > 0;)
    levels += levelComment(plan, i) + constructConstants(plan, i) + functions(plan, i);
  names.holes["LEVELS"] = levels;
  names.holes["PARTS"] = partChoice(plan);
  return fillFile(constructFiles(), "construct.cpp", names);
}

} // namespace voxc
