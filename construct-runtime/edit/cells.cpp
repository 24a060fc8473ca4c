constexpr uint64_t kWordsOfLevel${N} = ${slot-words-times}LEVEL_${N}_SHAPE.cells();

// True if a cell is not empty.
bool holds_any_level_${N}(const uint32_t *grid) {
  for (uint64_t word = 0; word < kWordsOfLevel${N}; word += ${slot-words})
    if (value_level_${N}(grid + word) != 0)
      return true;
  return false;
}

uint32_t change_level_${N}(Edit &edit, uint32_t old, Voxel low) {
  uint32_t *const grid = edit.open(${N}, old, kWordsOfLevel${N});
  if (!grid)
    return old;
  bool differs = false, lost = old == 0;
  CellBox flipped; // Cells that became empty, or no longer are.
  auto change = [&](Voxel cell, Voxel corner) {
    uint32_t *const slot = grid + ${slot-words-times}LEVEL_${N}_SHAPE.index(cell);
    const uint32_t before = value_level_${N}(slot);
    const uint32_t after = edit_${NEXT}(edit, before, corner);
    if (after == before)
      return;
    edit.touch(${N}, slot, ${slot-words});
    differs = true;
    lost |= after == 0;
    if (after != 0)
      set_value_level_${N}(slot, after);
    else
      set_empty_level_${N}(slot);
    if (before == 0 || after == 0)
      flipped.add(cell);
  };
  for_each_edited_cell<LEVEL_${N}_SHAPE>(edit, low, {}, LEVEL_${N}_SHAPE.longest(), change);
  const bool is_gone = lost && !holds_any_level_${N}(grid);
%if distances
  if (!is_gone && differs && old == 0)
    measure_level_${N}(edit, grid);
  else if (!is_gone && !flipped.is_empty())
    mend_level_${N}(edit, grid, flipped);
%end
  if (is_gone || !differs) {
    edit.abandon(${N});
    return is_gone ? 0 : old;
  }
  return edit.close(${N}, ${shares-grids});
}

// A sub-volume of voxels of one value.
uint32_t fill_level_${N}(Edit &edit, uint32_t value) {
  const uint32_t cell = filled_${NEXT}(edit, value);
  uint32_t *const grid = edit.open(${N}, 0, kWordsOfLevel${N});
  if (!grid)
    return 0;
  for (uint64_t word = 0; word < kWordsOfLevel${N}; word += ${slot-words})
    set_value_level_${N}(grid + word, cell);
  return edit.close(${N}, ${shares-grids});
}
