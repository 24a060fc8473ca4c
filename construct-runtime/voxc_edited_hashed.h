// voxc_edited_hashed.h: edits of tables: the cells that change are kept, then those that do not, and the
// table is written anew.
#pragma once

#include "voxc_edited.h"
#include "voxc_hashed.h"

namespace voxc::construct {

template <typename Level> struct EditedHashed {
  static uint32_t change(Edit &edit, uint32_t old, Voxel low) {
    bool differs = false;
    auto change = [&](Voxel cell, Voxel corner) {
      const auto number = static_cast<uint32_t>(Level::SHAPE.index(cell));
      const uint32_t before = edit.cell(Level::NUMBER, old, number);
      const uint32_t after = Level::Cells::edit(edit, before, corner);
      differs |= after != before;
      if (after != before)
        edit.keep(Level::NUMBER, number, after);
    };
    for_each_edited_cell<Level::SHAPE>(edit, low, {}, Level::SHAPE.longest(), change);
    uint32_t changed = old;
    if (differs) {
      edit.keep_others(Level::NUMBER, old);
      changed = write_kept(edit);
    }
    edit.drop(Level::NUMBER);
    return changed;
  }

  /// A sub-volume of voxels of one value.
  static uint32_t fill(Edit &edit, uint32_t value) {
    const uint32_t cell = Level::Cells::filled(edit, value);
    for (uint64_t number = 0; number < Level::SHAPE.cells(); ++number)
      edit.keep(Level::NUMBER, static_cast<uint32_t>(number), cell);
    const uint32_t offset = write_kept(edit);
    edit.drop(Level::NUMBER);
    return offset;
  }

private:
  /// Writes the cells that were kept; 0 if there are none.
  static uint32_t write_kept(Edit &edit) {
    uint64_t count = 0;
    const uint32_t *const cells = edit.kept(Level::NUMBER, count);
    return count == 0 ? 0 : HashedTable<Level>::write(edit, cells, count);
  }
};

} // namespace voxc::construct
