// voxc_edited_dense.h: edits of grids of a slot for each cell: slots change where they are, or in a copy.
#pragma once

#include "voxc_dense.h"
#include "voxc_edited.h"

namespace voxc::construct {

template <typename Level> struct EditedSlot {
  /// The value in a slot; 0 of a cell that is empty.
  static uint32_t value(const uint32_t *slot) { return SlotWord<Level>::value(*slot); }
  static void set_value(uint32_t *slot, uint32_t value) {
    slot[0] = SlotWord<Level>::of(value);
    if constexpr (Level::DISTANCES)
      if constexpr (Level::DISTANCES_BESIDE)
        slot[1] = 0;
  }
};

template <typename Level> struct EditedDense {
  static uint32_t change(Edit &edit, uint32_t old, Voxel low) {
    uint32_t *const grid = edit.open(Level::NUMBER, old, kWords);
    if (!grid)
      return old;
    bool differs = false, lost = old == 0;
    CellBox flipped; // Cells that became empty, or no longer are.
    auto change = [&](Voxel cell, Voxel corner) {
      uint32_t *const slot = grid + Level::SLOT_WORDS * Level::SHAPE.index(cell);
      const uint32_t before = Slot::value(slot);
      const uint32_t after = Level::Cells::edit(edit, before, corner);
      if (after == before)
        return;
      edit.touch(Level::NUMBER, slot, Level::SLOT_WORDS);
      differs = true;
      lost |= after == 0;
      set(slot, after);
      if (before == 0 || after == 0)
        flipped.add(cell);
    };
    for_each_edited_cell<Level::SHAPE>(edit, low, {}, Level::SHAPE.longest(), change);
    const bool is_gone = lost && !holds_any(grid);
    if constexpr (Level::DISTANCES)
      if (!is_gone && differs)
        mend(edit, grid, flipped, old == 0);
    if (is_gone || !differs) {
      edit.abandon(Level::NUMBER);
      return is_gone ? 0 : old;
    }
    return edit.close(Level::NUMBER, Level::INTERNS);
  }

  /// A sub-volume of voxels of one value.
  static uint32_t fill(Edit &edit, uint32_t value) {
    const uint32_t cell = Level::Cells::filled(edit, value);
    uint32_t *const grid = edit.open(Level::NUMBER, 0, kWords);
    if (!grid)
      return 0;
    for (uint64_t word = 0; word < kWords; word += Level::SLOT_WORDS)
      Slot::set_value(grid + word, cell);
    return edit.close(Level::NUMBER, Level::INTERNS);
  }

private:
  using Slot = EditedSlot<Level>;
  static constexpr uint64_t kWords = Level::SLOT_WORDS * Level::SHAPE.cells();

  static void set(uint32_t *slot, uint32_t value) {
    if (value != 0)
      return Slot::set_value(slot, value);
    if constexpr (Level::DISTANCES)
      Level::Mending::set_empty(slot);
    else
      *slot = 0;
  }

  /// True if a cell is not empty.
  static bool holds_any(const uint32_t *grid) {
    for (uint64_t word = 0; word < kWords; word += Level::SLOT_WORDS)
      if (Slot::value(grid + word) != 0)
        return true;
    return false;
  }

  static void mend(Edit &edit, uint32_t *grid, const CellBox &flipped, bool is_new) {
    if (is_new)
      Level::Field::measure(edit, grid);
    else if (!flipped.is_empty())
      Level::Mending::mend(edit, grid, flipped);
  }
};

} // namespace voxc::construct
