uint32_t change_level_${N}(Edit &edit, uint32_t old, Voxel low) {
  uint32_t *const grid = edit.allocate(${N}, kRoomForLevel${N});
  if (!grid)
    return old;
  uint32_t *const cells = grid + ${head-words};
  edit.read_cells(${N}, old, cells);
  bool differs = false;
  auto change = [&](Voxel cell, Voxel corner) {
    uint32_t &value = cells[LEVEL_${N}_SHAPE.index(cell)];
    const uint32_t after = edit_${NEXT}(edit, value, corner);
    differs |= after != value;
    value = after;
  };
  for_each_edited_cell<LEVEL_${N}_SHAPE>(edit, low, {}, LEVEL_${N}_SHAPE.longest(), change);
  bool holds_any = false;
  for (uint64_t cell = 0; cell < LEVEL_${N}_SHAPE.cells(); ++cell)
    holds_any |= cells[cell] != 0;
  const uint32_t changed = !differs ? old : holds_any ? write_level_${N}(edit, grid) : 0;
  edit.release(${N});
  return changed;
}

// A sub-volume of voxels of one value.
uint32_t fill_level_${N}(Edit &edit, uint32_t value) {
  const uint32_t filled = filled_${NEXT}(edit, value);
  uint32_t *const grid = edit.allocate(${N}, kRoomForLevel${N});
  if (!grid)
    return 0;
  for (uint64_t cell = 0; cell < LEVEL_${N}_SHAPE.cells(); ++cell)
    grid[${head-words} + cell] = filled;
  const uint32_t offset = write_level_${N}(edit, grid);
  edit.release(${N});
  return offset;
}
