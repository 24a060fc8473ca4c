// voxc_dense.h: grids of a slot for each cell, empty ones too.
#pragma once

#include "voxc_grid.h"

namespace voxc::construct {

/// Whether the word of an empty cell is 0, and no distance.
template <typename Level> constexpr bool empty_is_zero() {
  if constexpr (Level::DISTANCES)
    return Level::EMPTY_IS_ZERO;
  else
    return true;
}

/// The word of a slot, which holds a value, or says that its cell is empty.
template <typename Level> struct SlotWord {
  static constexpr bool is_empty(uint32_t word) {
    if constexpr (kIsPlain)
      return word == 0;
    else if constexpr (Level::EMPTY_BY_ALPHA)
      return word >> 24 == 0;
    else if constexpr (Level::DISTANCES_OF_OCTANTS)
      return (word & Level::FIELD_MASK) != 0;
    else
      return word >> 31 != 0;
  }
  static constexpr uint32_t of(uint32_t value) {
    if constexpr (kIsPlain)
      return value;
    else
      return value << Level::TAG_SHIFT;
  }
  /// 0 of a cell that is empty.
  static constexpr uint32_t value(uint32_t word) {
    if constexpr (kIsPlain)
      return word;
    else
      return is_empty(word) ? 0 : word >> Level::TAG_SHIFT;
  }

private:
  static constexpr bool kIsPlain = empty_is_zero<Level>();
};

/// A slot has a value; then, where they stand beside it, the distance of an empty cell; then, where levels
/// count voxels, how many come before the cell.
template <typename Level> struct DenseGrid : GridPart<Level> {
  /// Builds the sub-volume at `low`; returns what leads to it, 0 if it has no voxel.
  static uint32_t construct(Build &build, Voxel low) {
    uint32_t *grid = nullptr;
    uint32_t before = 0;
    auto place = [&](const PlacedCell &placed) {
      if (!grid && !(grid = build.allocate(Level::NUMBER, kWords)))
        return;
      uint32_t *const slot = grid + Level::SLOT_WORDS * Level::SHAPE.index(placed.cell);
      slot[0] = SlotWord<Level>::of(placed.value);
      if constexpr (Level::RANKED) {
        slot[Level::SLOT_WORDS - 1] = before;
        before += placed.voxels;
      }
    };
    for_each_cell<Level>(build, low, {}, Level::SHAPE.longest(), place);
    if (!grid)
      return 0;
    if constexpr (Level::DISTANCES)
      Level::Field::measure(build, grid);
    const uint32_t offset = put_words<Level>(build, grid, kWords);
    build.release(Level::NUMBER);
    return offset;
  }

private:
  static constexpr uint64_t kWords = Level::SLOT_WORDS * Level::SHAPE.cells();
};

} // namespace voxc::construct
