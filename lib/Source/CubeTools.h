// What every source needs to know of cubes: whether they reach into the extent, and their cells in Morton
// order.
#pragma once

#include "voxc/Support/Geometry.h"

#include <cstdint>

namespace voxc {

/// True if no cell of `cube` lies in [0, extent).
inline bool isOutside(const Cube &cube, Int3 extent) {
  for (int axis = 0; axis < 3; ++axis)
    if (cube.low[axis] >= extent[axis] || cube.low[axis] + cube.side() <= 0)
      return true;
  return false;
}

/// Number of cells in a cube.
constexpr std::uint64_t cellCount(int log2Side) { return std::uint64_t{1} << 3 * log2Side; }

/// Calls `visit(index, cell)` for every cell of `cube` in Morton order.
template <typename Visit> void forEachCell(const Cube &cube, Visit visit) {
  for (std::uint64_t index = 0; index < cellCount(cube.log2Side); ++index)
    visit(index, cube.low + mortonCell(index));
}

} // namespace voxc
