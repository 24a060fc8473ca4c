// Small scenes that are chosen to hurt, for tests of whole pipelines.
#pragma once

#include "voxc/Source/Sources.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace voxc::test {

/// A scene of a given extent, made anew for each use because sources are read once, in order.
struct Scene {
  std::string name;
  std::function<std::uint32_t(Int3)> voxel;
  Int3 extent;

  std::unique_ptr<VoxelSource> source() const { return makeFunctionSource(extent, voxel); }
};

inline std::uint32_t hashed(Int3 cell) {
  std::uint32_t h = static_cast<std::uint32_t>(cell.x) * 0x9e3779b1u ^
                    static_cast<std::uint32_t>(cell.y) * 0x85ebca77u ^
                    static_cast<std::uint32_t>(cell.z) * 0xc2b2ae3du;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  return h ^ h >> 13;
}

/// Scenes that fill `extent`.
inline std::vector<Scene> hardScenes(Int3 extent) {
  const Int3 last = extent - Int3{1, 1, 1};
  std::vector<Scene> scenes;
  const auto add = [&](std::string name, std::function<std::uint32_t(Int3)> voxel) {
    scenes.push_back({std::move(name), std::move(voxel), extent});
  };
  add("empty", [](Int3) { return 0u; });
  add("full", [](Int3) { return 0xff336699u; });
  add("full of colours", [](Int3 cell) { return hashed(cell) | 0xff000000u; });
  add("checkerboard", [](Int3 c) { return (c.x + c.y + c.z) % 2 == 0 ? 0xff00ff00u : 0u; });
  add("two-coloured checkerboard", [](Int3 c) { return (c.x + c.y + c.z) % 2 == 0 ? 1u : 2u; });
  add("uniform blocks", [](Int3 c) { return hashed(c >> 2) % 3 == 0 ? 0xff0000ffu : 0u; });
  add("dust", [](Int3 c) { return hashed(c) % 100 == 0 ? 0xffffffffu : 0u; });
  add("half dust", [](Int3 c) { return hashed(c) % 2 == 0 ? hashed(c) | 1u : 0u; });
  add("one layer", [](Int3 c) { return c.y == 0 ? 0xff777777u : 0u; });
  for (int corner = 0; corner < 8; ++corner) {
    const Int3 at = {corner & 1 ? last.x : 0, corner & 2 ? last.y : 0, corner & 4 ? last.z : 0};
    add("corner " + std::to_string(corner), [at](Int3 c) { return c == at ? 0xff010203u : 0u; });
  }
  return scenes;
}

} // namespace voxc::test
