// The functions of a kernel: the runtime files that a plan names, in order of use, with each level's
// constants.
#include "KernelFunctions.h"

#include "RuntimeFile.h"

#include <set>

namespace voxc {
namespace {

std::string intVector(Int3 v) {
  return "ivec3(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

class FunctionEmitter {
public:
  explicit FunctionEmitter(const Plan &plan) : plan_(plan) {}

  std::string emit() {
    for (const char *path : {"ray.glsl", "number.glsl", "products.glsl", "crossing.glsl"})
      file(path);
    file("step/" + std::string(toString(plan_.predicate)) + ".glsl");
    for (const char *path : {"step.glsl", "enter.glsl", "time.glsl", "unit.glsl"})
      file(path);
    if (plan_.detail == Detail::Cone)
      file("detail/cone.glsl");
    // A function stands before its callers: the last level first.
    for (auto level = plan_.levels.rbegin(); level != plan_.levels.rend(); ++level)
      emitLevel(*level);
    file("root.glsl");
    return std::move(text_);
  }

private:
  /// A file that does not depend on a level, once.
  void file(const std::string &path) {
    if (written_.insert(path).second)
      text_ += "\n" + std::string(runtimeFile(shaderFiles(), path));
  }

  /// A file that is written for each level.
  void leaf(const LevelPlan &level, const std::string &path) {
    text_ += instantiate(stopping(level, path), plan_, level);
  }

  /// A file that is written for each height of a tree, from the lowest nodes up.
  void nodes(const LevelPlan &level, const std::string &path) {
    const std::string text = stopping(level, path);
    for (int height = 1; height <= level.log2Size.x; ++height)
      text_ += (height > 1 ? "\n" : "") +
               instantiate(resolveConditions(text, "INNER", height > 1), plan_, level, height);
  }

  /// A file with what it needs to stop above voxels, or without.
  static std::string stopping(const LevelPlan &level, const std::string &path) {
    return resolveConditions(runtimeFile(shaderFiles(), path), "CONE", level.stops);
  }

  void emitLevel(const LevelPlan &level) {
    const bool isTree = level.kind->arrangement == Arrangement::Tree;
    if (level.descent != Descent::Single)
      file("level/" + std::string(level.kind->name) + ".glsl");
    if (isTree && level.descent != Descent::Single)
      file("walk/tree.glsl");
    if (level.sampled && level.descent != Descent::Single)
      file("detail/" + std::string(level.kind->name) + ".glsl");
    text_ += levelComment(level);
    const std::string prefix = "LEVEL_" + std::to_string(level.number) + "_";
    if (isTree)
      text_ += "const int " + prefix + "DEPTH = " + std::to_string(level.log2Size.x) + ";\n";
    else
      text_ += "const ivec3 " + prefix + "LOG2_SIZE = " + intVector(level.log2Size) + ";\n";
    text_ += "const int " + prefix + "LOG2_CELL = " + std::to_string(level.log2CellSide) + ";\n\n";
    if (level.sampled)
      leaf(level, isTree ? level.descent == Descent::Single ? "detail/single.glsl" : "detail/tree.glsl"
                         : "detail/grid.glsl");
    const std::string walk = "walk/" + std::string(toString(level.descent)) + ".glsl";
    if (level.descent == Descent::Unrolled)
      nodes(level, walk);
    else
      leaf(level, walk);
  }

  const Plan &plan_;
  std::string text_;
  std::set<std::string> written_;
};

} // namespace

std::string kernelFunctions(const Plan &plan) { return FunctionEmitter(plan).emit(); }

std::string volumeSize(const Plan &plan) {
  return "\n// Voxels along each axis.\nconst ivec3 VOLUME_SIZE = " + intVector(plan.format.extent()) + ";\n";
}

} // namespace voxc
