// voxc_edited_masked.h: edits of masked grids, which are filled with the cells that they had, and written
// anew.
#pragma once

#include "voxc_edited.h"
#include "voxc_masked.h"

namespace voxc::construct {

template <typename Level> struct EditedMasked {
  static uint32_t change(Edit &edit, uint32_t old, Voxel low) {
    uint32_t *const grid = edit.allocate(Level::NUMBER, Level::Writing::kRoom);
    if (!grid)
      return old;
    uint32_t *const cells = grid + FilledGrid<Level>::kHead;
    edit.read_cells(Level::NUMBER, old, cells);
    bool differs = false;
    auto change = [&](Voxel cell, Voxel corner) {
      uint32_t &value = cells[Level::SHAPE.index(cell)];
      const uint32_t after = Level::Cells::edit(edit, value, corner);
      differs |= after != value;
      value = after;
    };
    for_each_edited_cell<Level::SHAPE>(edit, low, {}, Level::SHAPE.longest(), change);
    bool holds_any = false;
    for (uint64_t cell = 0; cell < Level::SHAPE.cells(); ++cell)
      holds_any |= cells[cell] != 0;
    const uint32_t changed = !differs ? old : holds_any ? Level::Writing::write(edit, grid) : 0;
    edit.release(Level::NUMBER);
    return changed;
  }

  /// A sub-volume of voxels of one value.
  static uint32_t fill(Edit &edit, uint32_t value) {
    const uint32_t filled = Level::Cells::filled(edit, value);
    uint32_t *const grid = edit.allocate(Level::NUMBER, Level::Writing::kRoom);
    if (!grid)
      return 0;
    for (uint64_t cell = 0; cell < Level::SHAPE.cells(); ++cell)
      grid[FilledGrid<Level>::kHead + cell] = filled;
    const uint32_t offset = Level::Writing::write(edit, grid);
    edit.release(Level::NUMBER);
    return offset;
  }
};

} // namespace voxc::construct
