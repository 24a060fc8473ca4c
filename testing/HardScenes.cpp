// The table of scenes that are chosen to hurt.
#include "testing/HardScenes.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace voxc::test {

namespace {

constexpr int kLargestFilled = 64;
constexpr int kClusterSide = 32;

std::uint32_t hashed(Int3 cell) {
  std::uint32_t h = static_cast<std::uint32_t>(cell.x) * 0x9e3779b1u ^
                    static_cast<std::uint32_t>(cell.y) * 0x85ebca77u ^
                    static_cast<std::uint32_t>(cell.z) * 0xc2b2ae3du;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  return h ^ h >> 13;
}

bool isEven(Int3 c) { return (c.x + c.y + c.z) % 2 == 0; }

/// The cells of one voxel's thickness that are 13 steps from the middle of their block of 32 cells.
bool isShell(Int3 c) {
  constexpr int kRadius = 13;
  const auto fromMiddle = [](int coordinate) { return std::abs(2 * (coordinate % 32) - 31) / 2; };
  return std::max({fromMiddle(c.x), fromMiddle(c.y), fromMiddle(c.z)}) == kRadius;
}

/// Tunnels of one cell's width along all three axes, in every fourth cell.
bool isTunnel(Int3 c) {
  const int inside = (c.x % 4 == 1) + (c.y % 4 == 1) + (c.z % 4 == 1);
  return inside >= 2;
}

struct Row {
  const char *name;
  std::uint32_t (*voxel)(Int3 cell);
};

constexpr Row kPatterns[] = {
    {"empty", [](Int3) { return 0u; }},
    {"full", [](Int3) { return 0xff336699u; }},
    {"colours", [](Int3 c) { return hashed(c) | 0xff000000u; }},
    {"checkerboard", [](Int3 c) { return isEven(c) ? 0xff00ff00u : 0u; }},
    {"two-colours", [](Int3 c) { return isEven(c) ? 1u : 2u; }},
    {"blocks", [](Int3 c) { return hashed(c >> 2) % 3 == 0 ? 0xff0000ffu : 0u; }},
    {"dust", [](Int3 c) { return hashed(c) % 100 == 0 ? 0xffffffffu : 0u; }},
    {"half-dust", [](Int3 c) { return hashed(c) % 2 == 0 ? hashed(c) | 1u : 0u; }},
    {"layer", [](Int3 c) { return c.y == 0 ? 0xff777777u : 0u; }},
    {"slope", [](Int3 c) { return (c.x + c.y + c.z) % 32 == 31 ? 0xff2277ccu : 0u; }},
    {"shells", [](Int3 c) { return isShell(c) ? 0xff99aa22u : 0u; }},
    {"tunnels", [](Int3 c) { return isTunnel(c) ? 0u : hashed(c >> 3) | 1u; }},
};

bool isOutside(const Cube &cube, Int3 low, Int3 high) {
  for (int axis = 0; axis < 3; ++axis)
    if (cube.low[axis] >= high[axis] || cube.low[axis] + cube.side() <= low[axis])
      return true;
  return false;
}

/// The low corners of the cubes in which a large extent is filled.
std::vector<Int3> clustersOf(Int3 extent) {
  std::vector<Int3> lows;
  lows.reserve(9);
  const auto last = [](int size) { return std::max(size - kClusterSide, 0); };
  for (int corner = 0; corner < 8; ++corner)
    lows.push_back(
        {corner & 1 ? last(extent.x) : 0, corner & 2 ? last(extent.y) : 0, corner & 4 ? last(extent.z) : 0});
  lows.push_back({last(extent.x) / 2, last(extent.y) / 2, last(extent.z) / 2});
  return lows;
}

/// The scene in the clusters of its extent alone.
HardScene inClusters(HardScene scene) {
  const auto outside = [lows = clustersOf(scene.extent)](const Cube &cube) {
    return std::ranges::all_of(lows, [&](Int3 low) {
      return isOutside(cube, low, low + Int3{kClusterSide, kClusterSide, kClusterSide});
    });
  };
  scene.voxel = [voxel = std::move(scene.voxel), outside](Int3 c) { return outside({c, 0}) ? 0u : voxel(c); };
  scene.empty = outside;
  return scene;
}

HardScene singleVoxel(Int3 extent, int corner) {
  const Int3 last = extent - Int3{1, 1, 1};
  const Int3 at{corner & 1 ? last.x : 0, corner & 2 ? last.y : 0, corner & 4 ? last.z : 0};
  return {"corner-" + std::to_string(corner), [at](Int3 c) { return c == at ? 0xff010203u : 0u; },
          [at](const Cube &cube) { return isOutside(cube, at, at + Int3{1, 1, 1}); }, extent};
}

} // namespace

std::vector<HardScene> hardScenes(Int3 extent) {
  std::vector<HardScene> scenes;
  const bool isLarge = std::max({extent.x, extent.y, extent.z}) > kLargestFilled;
  for (const Row &row : kPatterns) {
    HardScene scene{row.name, row.voxel, {}, extent};
    scenes.push_back(isLarge ? inClusters(std::move(scene)) : std::move(scene));
  }
  for (int corner = 0; corner < 8; ++corner)
    scenes.push_back(singleVoxel(extent, corner));
  return scenes;
}

} // namespace voxc::test
