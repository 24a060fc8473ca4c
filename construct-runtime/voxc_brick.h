// voxc_brick.h: masked grids of 4 x 4 x 4 voxels, which need no more than their mask.
#pragma once

#include "voxc_masked.h"

namespace voxc::construct {

template <typename Level> struct BrickPacking {
  /// Turns a grid into the mask of the cells that are not empty. Values that are apart are put in Morton
  /// order.
  static uint64_t pack(Build &build, uint32_t *grid) {
    constexpr uint64_t kHead = FilledGrid<Level>::kHead;
    if constexpr (Level::RANKED)
      for (unsigned i = 0; i < Level::SHAPE.cells(); ++i)
        if (const uint32_t value = grid[kHead + Level::SLOT_WORDS * Level::SHAPE.index(brick_voxel(i))])
          build.put_value(value);
    for (uint64_t cell = 0; cell < Level::SHAPE.cells(); ++cell)
      if (grid[kHead + Level::SLOT_WORDS * cell] != 0)
        grid[cell / 32] |= 1u << cell % 32;
    build.pause(32768);
    return kHead;
  }
};

template <typename Level> struct BrickWriting : PackedGrid<Level, BrickPacking> {};

} // namespace voxc::construct
