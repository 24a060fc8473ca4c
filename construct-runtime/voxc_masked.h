// voxc_masked.h: grids of a mask of the cells that are not empty, and a slot for each of these. A grid is
// filled as slots of all cells, behind room for the mask, and packed when it is complete.
#pragma once

#include "voxc_grid.h"

namespace voxc::construct {

/// Where the words of a grid that is being filled have the slots of all cells, and how many words there are.
template <typename Level> struct FilledGrid {
  static constexpr uint64_t kHead = Level::HEAD_WORDS;
  static constexpr uint64_t kWords = kHead + Level::SLOT_WORDS * Level::SHAPE.cells();
};

template <typename Level> struct MaskPacking {
  /// Turns a grid into the mask and the slots of the cells that are not empty; where cells are known without
  /// slots, into the mask. Values that are apart are put in the order of the bits. Returns how many words
  /// that takes.
  static uint64_t pack(Build &build, uint32_t *grid) {
    constexpr uint64_t kHead = FilledGrid<Level>::kHead;
    uint64_t end = kHead;
    uint32_t count = 0;
    for (uint64_t first = 0; first < Level::SHAPE.cells(); first += 32) {
      uint32_t *const mask = grid + first / 32 * (Level::COUNTS ? 2 : 1);
      if constexpr (Level::COUNTS)
        mask[1] = count;
      for (uint64_t cell = first; cell < Level::SHAPE.cells() && cell < first + 32; ++cell) {
        const uint32_t *const slot = grid + kHead + Level::SLOT_WORDS * cell;
        if (*slot == 0)
          continue;
        *mask |= 1u << (cell - first);
        ++count;
        if constexpr (!Level::IMPLIED)
          grid[end++] = slot[0];
        if constexpr (!Level::IMPLIED && Level::RANKED)
          grid[end++] = slot[1];
        if constexpr (Level::IMPLIED && Level::RANKED)
          build.put_value(*slot);
      }
      if (first % 32768 == 0)
        build.pause(32768);
    }
    return end;
  }
};

/// Writes a filled grid as `Packing` makes it.
template <typename Level, template <typename> typename Packing> struct PackedGrid {
  static constexpr uint64_t kRoom = FilledGrid<Level>::kWords; ///< For a grid that is being filled.

  /// Returns what leads to the grid.
  static uint32_t write(Build &build, uint32_t *grid) {
    const uint64_t words = Packing<Level>::pack(build, grid);
    return put_words<Level>(build, grid, words);
  }
};

template <typename Level> struct MaskWriting : PackedGrid<Level, MaskPacking> {};

template <typename Level> struct MaskedGrid : GridPart<Level> {
  /// Builds the sub-volume at `low`; returns what leads to it, 0 if it has no voxel.
  static uint32_t construct(Build &build, Voxel low) {
    uint32_t *grid = nullptr;
    uint32_t before = 0;
    auto place = [&](const PlacedCell &placed) {
      if (!grid && !(grid = build.allocate(Level::NUMBER, Level::Writing::kRoom)))
        return;
      uint32_t *const slot =
          grid + FilledGrid<Level>::kHead + Level::SLOT_WORDS * Level::SHAPE.index(placed.cell);
      slot[0] = placed.value;
      if constexpr (Level::RANKED && !Level::IMPLIED) {
        slot[1] = before;
        before += placed.voxels;
      }
    };
    for_each_cell<Level>(build, low, {}, Level::SHAPE.longest(), place);
    if (!grid)
      return 0;
    const uint32_t offset = Level::Writing::write(build, grid);
    build.release(Level::NUMBER);
    return offset;
  }
};

} // namespace voxc::construct
