// Constants and leaves of construct-runtime for a level.
#include "ConstructLevel.h"

#include "Names.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Layout/SlotKind.h"

#include <algorithm>

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

} // namespace

std::string constructConstants(const Plan &plan, std::size_t index) {
  const Stratum &stratum = plan.layout.strata[index];
  const std::string prefix = "LEVEL_" + std::to_string(index + 1) + "_";
  return stratum.isGrid() ? gridConstants(stratum, plan.layout.holdsVoxels(index), prefix)
                          : treeConstants(stratum, prefix);
}

std::string constructLeaf(const Plan &plan, std::size_t index, const std::string &file) {
  return "\n" + fillFile(constructFiles(), file + ".cpp", stratumNames(plan, index));
}

std::string constructPlanes(const Plan &plan) {
  return std::ranges::any_of(plan.layout.strata, reportsBall)
             ? "\n" + fillFile(constructFiles(), "distances/plane.cpp", planNames(plan))
             : "";
}

} // namespace voxc
