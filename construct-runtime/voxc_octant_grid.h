// voxc_octant_grid.h: grids of a bit a cell, in Morton order, until the array of all is written by octants.
#pragma once

#include "voxc_grid.h"

namespace voxc::construct {

/// Values that are apart are put in the same order.
template <typename Level> struct OctantGrid : GridPart<Level> {
  /// Builds the sub-volume at `low`; returns its number, 0 if it has no voxel.
  static uint32_t construct(Build &build, Voxel low) {
    uint32_t *grid = nullptr;
    auto place = [&](const PlacedCell &placed) {
      if (!grid && !(grid = build.allocate(Level::NUMBER, Level::HEAD_WORDS)))
        return;
      const unsigned index = brick_index(placed.cell);
      grid[index / 32] |= 1u << index % 32;
      if constexpr (Level::RANKED)
        build.put_value(placed.value);
    };
    for_each_cell<Level>(build, low, {}, Level::SHAPE.longest(), place);
    if (!grid)
      return 0;
    const uint32_t number = put_words<Level>(build, grid, Level::HEAD_WORDS);
    build.release(Level::NUMBER);
    return number;
  }
};

} // namespace voxc::construct
