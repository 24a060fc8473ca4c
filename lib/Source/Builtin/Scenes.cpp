// The table of built-in scenes.
#include "Source/Builtin/Scenes.h"

#include "voxc/Source/Sources.h"

#include <array>

namespace voxc {

namespace {

constexpr std::array<BuiltinScene, 9> kScenes{{
    {"terrain", "a landscape with mountains, lakes and trees, cut open at the sides", makeTerrain},
    {"shell", "a hollow sphere, one voxel thick", makeShell},
    {"menger", "a Menger sponge", makeMenger},
    {"full", "every voxel", makeFull},
    {"empty", "no voxel", makeEmpty},
    {"voxel", "a single voxel in the middle", makeVoxel},
    {"corners", "one voxel in each of the eight corners", makeCorners},
    {"checker", "every other voxel, as on a chess board", makeChecker},
    {"dust", "one voxel of a hundred, scattered", makeDust},
}};

} // namespace

std::span<const BuiltinScene> builtinScenes() { return kScenes; }

Expected<std::unique_ptr<VoxelSource>> makeBuiltinSource(std::string_view name, int side) {
  if (side < 1 || side > 1 << kMaxLog2Extent)
    return Error::input("a built-in scene cannot have " + std::to_string(side) +
                        " voxels an axis; it takes 1 to 2097152");
  std::string names;
  for (const BuiltinScene &scene : kScenes) {
    if (scene.name == name)
      return scene.make(side);
    names += (names.empty() ? "" : ", ") + std::string(scene.name);
  }
  return Error::input("there is no built-in scene '" + std::string(name) + "'; there are " + names);
}

} // namespace voxc
