// Printing a plan as edit.cpp: what changes a sub-volume of each level, the last level first.
#include "ConstructLevel.h"
#include "Names.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Layout/SlotKind.h"

#include <vector>

namespace voxc {
namespace {

/// The runtime files of a level, in the order in which they are printed: what makes nodes, as construction
/// has it, and then what changes them.
std::vector<std::string> filesOf(const Stratum &stratum) {
  const SlotKind &kind = *stratum.slots;
  const Distances *const distances = stratum.distances();
  const std::string metric = distances ? "distances/" + std::string(toString(distances->metric)) : "";
  std::vector<std::string> files;
  if (distances)
    files.push_back(metric);
  for (const std::string_view file : kind.writing(stratum))
    files.push_back("slots/" + std::string(file));
  if (kind.root)
    files.insert(files.end(), {"descent/join", "root/" + std::string(kind.root(stratum))});
  if (kind.keepsEmpty)
    files.emplace_back("edit/slot");
  if (distances)
    files.push_back(metric + "-mend");
  files.insert(files.end(), {"edit/fill", "edit/" + std::string(kind.edit), "edit/sub-volume"});
  return files;
}

std::string editFunctions(const Plan &plan, std::size_t index) {
  std::string lines;
  for (const std::string &file : filesOf(plan.layout.strata[index]))
    lines += constructLeaf(plan, index, file);
  return lines;
}

std::string sideConstant(const Stratum &stratum, std::size_t index) {
  return "constexpr int LEVEL_" + std::to_string(index + 1) +
         "_LOG2_SIDE = " + std::to_string(longest(stratum.log2Size()) + stratum.log2Cell) + ";\n";
}

} // namespace

std::string emitEdit(const Plan &given) {
  Plan plan = given;
  for (Construction &construction : plan.constructions)
    construction.looksAhead = false; // There are too few nodes for it.
  TemplateNames names = planNames(plan);
  std::string levels = constructPlanes(plan);
  for (std::size_t i = plan.layout.strata.size(); i-- > 0;)
    levels += levelComment(plan, i) + constructConstants(plan, i) + sideConstant(plan.layout.strata[i], i) +
              editFunctions(plan, i);
  names.holes["LEVELS"] = levels;
  return fillFile(constructFiles(), "edit/edit.cpp", names);
}

} // namespace voxc
