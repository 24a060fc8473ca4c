// Printing a plan as construct.cpp: one function a level, the last level first.
#include "RuntimeFile.h"

#include "voxc/Emit/Emit.h"

#include <vector>

namespace voxc {
namespace {

bool isTree(const LevelPlan &level) { return level.kind->arrangement == Arrangement::Tree; }

const char *text(bool value) { return value ? "true" : "false"; }

std::string treeConstants(const LevelPlan &level, const std::string &prefix) {
  std::string lines = "constexpr int " + prefix + "DEPTH = " + std::to_string(level.log2Size.x) + ";\n";
  lines += "constexpr int " + prefix + "LOG2_CELL = " + std::to_string(level.log2CellSide) + ";\n";
  if (level.sharing != Sharing::None)
    lines += "constexpr bool " + prefix +
             "SHARES_ACROSS_SUB_VOLUMES = " + text(level.sharing == Sharing::Level) + ";\n";
  return lines;
}

std::string gridConstants(const LevelPlan &level, const std::string &prefix) {
  const Int3 size = level.log2Size;
  std::string lines = "constexpr GridShape " + prefix + "SHAPE = {" + std::to_string(size.x) + ", " +
                      std::to_string(size.y) + ", " + std::to_string(size.z) + ", " +
                      std::to_string(level.log2CellSide) + "};\n";
  if (level.reach > 0)
    lines += "constexpr uint32_t " + prefix + "REACH = " + std::to_string(level.reach) + ";\n";
  return lines + "constexpr bool " + prefix + "SHARES_GRIDS = " + text(level.sharing == Sharing::Level) +
         ";\n";
}

std::string constants(const LevelPlan &level) {
  const std::string prefix = "LEVEL_" + std::to_string(level.number) + "_";
  return isTree(level) ? treeConstants(level, prefix) : gridConstants(level, prefix);
}

/// The runtime files of a level's construction, in the order in which they are printed.
std::vector<std::string> filesOf(const Plan &plan, const LevelPlan &level) {
  const std::string kind = "level/" + std::string(level.kind->name) + ".cpp";
  if (!isTree(level))
    return {kind, "part/grid.cpp"};
  const bool isLast = &level == &plan.levels.back();
  const char *const descent = isLast ? "descent/voxels.cpp" : "descent/cells.cpp";
  return {kind, "descent/join.cpp", descent, "part/tree.cpp"};
}

std::string functions(const Plan &plan, const LevelPlan &level) {
  std::string lines;
  for (const std::string &file : filesOf(plan, level))
    lines += "\n" + instantiate(runtimeFile(constructFiles(), file), plan, level);
  return lines;
}

/// Which level an aligned cube belongs to when it is built apart: the highest with smaller cells.
std::string partChoice(const Plan &plan) {
  std::string lines;
  for (const LevelPlan &level : plan.levels) {
    const std::string number = std::to_string(level.number);
    const bool isLast = &level == &plan.levels.back();
    lines += isLast ? "  " : "  if (log2_side > " + std::to_string(level.log2CellSide) + ")\n    return ";
    lines += "construct_level_" + number + "_part(build, {x, y, z}, log2_side);\n";
  }
  return lines;
}

} // namespace

std::string_view constructHeader() { return runtimeFile(constructFiles(), "voxc_construct.h"); }

std::string emitConstruct(const Plan &plan) {
  std::string lines = "// construct.cpp: builds volumes of the format " + toString(plan.format) +
                      ".\n#include \"voxc_construct.h\"\n\nusing namespace voxc::construct;\n\nnamespace {\n";
  for (auto level = plan.levels.rbegin(); level != plan.levels.rend(); ++level)
    lines += levelComment(*level) + constants(*level) + functions(plan, *level);
  lines += "\n} // namespace\n\n// Returns the offset of the root sub-volume; 0 if there is no voxel.\n"
           "extern \"C\" uint32_t voxc_construct(const Host *host) {\n"
           "  Build build(*host);\n  return construct_level_1(build, {});\n}\n";
  return lines +
         "\n// Builds the aligned cube of 2^log2_side voxels a side at (x, y, z) apart from the rest.\n"
         "extern \"C\" void voxc_construct_part(const Host *host, int x, int y, int z, int "
         "log2_side) {\n  Build build(*host);\n" +
         partChoice(plan) + "}\n";
}

} // namespace voxc
