// Scenes by their names.
#include "Scenes.h"

#include "testing/HardScenes.h"
#include "voxc/Source/Sources.h"

#include <array>

namespace voxc::cliffs {
namespace {

/// Built-in scenes that hold surfaces and holes of all sizes; each stands for two, as most scenes are so.
constexpr std::array<std::string_view, 6> kBuiltin = {"terrain", "terrain", "shell",
                                                      "shell",   "menger",  "menger"};
constexpr int kLargestBuiltin = 512;

bool takesBuiltin(Int3 extent) {
  return extent.x == extent.y && extent.y == extent.z && extent.x <= kLargestBuiltin && extent.x >= 16;
}

} // namespace

std::vector<std::string> sceneNames(Int3 extent) {
  std::vector<std::string> names;
  for (const test::HardScene &scene : test::hardScenes(extent))
    if (!scene.name.starts_with("corner-") || scene.name == "corner-0" || scene.name == "corner-7")
      names.push_back(scene.name);
  if (takesBuiltin(extent))
    names.insert(names.end(), kBuiltin.begin(), kBuiltin.end());
  return names;
}

Expected<std::unique_ptr<VoxelSource>> openScene(std::string_view name, Int3 extent) {
  for (const test::HardScene &scene : test::hardScenes(extent))
    if (scene.name == name)
      return scene.source();
  return makeBuiltinSource(name, extent.x);
}

} // namespace voxc::cliffs
