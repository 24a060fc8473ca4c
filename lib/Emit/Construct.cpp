// Printing a plan as construct.cpp: one function a level, the last level first.
#include "RuntimeFile.h"

#include "voxc/Emit/Emit.h"

namespace voxc {
namespace {

std::string constants(const LevelPlan &level) {
  const std::string prefix = "LEVEL_" + std::to_string(level.number) + "_";
  const Int3 size = level.log2Size;
  std::string text;
  if (level.kind->arrangement == Arrangement::Tree)
    text += "constexpr int " + prefix + "DEPTH = " + std::to_string(size.x) + ";\n";
  else
    text += "constexpr GridSize " + prefix + "SIZE = {" + std::to_string(size.x) + ", " +
            std::to_string(size.y) + ", " + std::to_string(size.z) + "};\n";
  text += "constexpr int " + prefix + "LOG2_CELL = " + std::to_string(level.log2CellSide) + ";\n";
  if (level.reach > 0)
    text += "constexpr uint32_t " + prefix + "REACH = " + std::to_string(level.reach) + ";\n";
  if (level.sharing != Sharing::None)
    text += "constexpr bool " + prefix +
            "SHARES_ACROSS_SUB_VOLUMES = " + (level.sharing == Sharing::Level ? "true" : "false") + ";\n";
  return text;
}

/// The runtime files of a level's construction: its kind's and, for trees, the descent that they share.
std::string functions(const Plan &plan, const LevelPlan &level) {
  std::string text(runtimeFile(constructFiles(), "level/" + std::string(level.kind->name) + ".cpp"));
  if (level.kind->arrangement == Arrangement::Tree)
    text += "\n" + std::string(runtimeFile(constructFiles(), "tree.cpp"));
  return instantiate(text, plan, level);
}

} // namespace

std::string_view constructHeader() { return runtimeFile(constructFiles(), "voxc_construct.h"); }

std::string emitConstruct(const Plan &plan) {
  std::string text = "// construct.cpp: builds volumes of the format " + toString(plan.format) +
                     ".\n#include \"voxc_construct.h\"\n\nusing namespace voxc::construct;\n\nnamespace {\n\n"
                     "uint32_t construct_voxel(Build &build, Voxel at) { return build.voxel(at); }\n";
  for (auto level = plan.levels.rbegin(); level != plan.levels.rend(); ++level)
    text += levelComment(*level) + constants(*level) + "\n" + functions(plan, *level);
  return text + "\n} // namespace\n\n// Returns the offset of the root sub-volume; 0 if there is no voxel.\n"
                "extern \"C\" uint32_t voxc_construct(const Host *host) {\n"
                "  Build build(*host);\n  return construct_level_1(build, {});\n}\n";
}

} // namespace voxc
