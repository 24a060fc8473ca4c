// Scenes that test a format's extremes: full, empty, a voxel, corners, a chess board, dust.
#include "Source/Builtin/Scenes.h"

#include <algorithm>

namespace voxc {

namespace {

constexpr std::uint32_t kStone = rgba(196, 189, 178);
constexpr std::uint32_t kDark = rgba(58, 62, 74);
constexpr std::uint32_t kSignal = rgba(228, 92, 46);

Int3 cubeOf(int side) { return {side, side, side}; }

bool holds(const Cube &cube, Int3 cell) {
  const Int3 offset = cell - cube.low;
  return std::min({offset.x, offset.y, offset.z}) >= 0 &&
         std::max({offset.x, offset.y, offset.z}) < cube.side();
}

/// True if [low, low + side) holds the first or the last of `extent` cells.
bool reachesEnd(std::int32_t low, std::int64_t side, int extent) { return low <= 0 || low + side >= extent; }

} // namespace

std::unique_ptr<VoxelSource> makeFull(int side) {
  return makeFunctionSource(cubeOf(side), [](Int3) { return kStone; });
}

std::unique_ptr<VoxelSource> makeEmpty(int side) {
  return makeFunctionSource(cubeOf(side), [](Int3) { return 0u; }, [](const Cube &) { return true; });
}

std::unique_ptr<VoxelSource> makeVoxel(int side) {
  const Int3 middle{side / 2, side / 2, side / 2};
  return makeFunctionSource(
      cubeOf(side), [middle](Int3 cell) { return cell == middle ? kSignal : 0; },
      [middle](const Cube &cube) { return !holds(cube, middle); });
}

std::unique_ptr<VoxelSource> makeCorners(int side) {
  const auto isEnd = [side](std::int32_t coordinate) { return reachesEnd(coordinate, 1, side); };
  return makeFunctionSource(
      cubeOf(side), [isEnd](Int3 c) { return isEnd(c.x) && isEnd(c.y) && isEnd(c.z) ? kSignal : 0; },
      [side](const Cube &cube) {
        return !(reachesEnd(cube.low.x, cube.side(), side) && reachesEnd(cube.low.y, cube.side(), side) &&
                 reachesEnd(cube.low.z, cube.side(), side));
      });
}

std::unique_ptr<VoxelSource> makeChecker(int side) {
  // Squares of two colours on every layer, so that the gaps between the voxels can be seen.
  return makeFunctionSource(cubeOf(side), [](Int3 cell) -> std::uint32_t {
    if (((cell.x + cell.y + cell.z) & 1) != 0)
      return 0;
    return (cell.y & 1) != 0 ? kDark : kStone;
  });
}

std::unique_ptr<VoxelSource> makeDust(int side) {
  constexpr std::uint32_t kSeed = 7;
  return makeFunctionSource(cubeOf(side), [](Int3 cell) -> std::uint32_t {
    const std::uint32_t hash = hashCell(cell, kSeed);
    return hash % 100 == 0 ? hash | 0xff000000u : 0;
  });
}

} // namespace voxc
