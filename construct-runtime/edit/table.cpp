// Writes the cells that were kept; 0 if there are none.
uint32_t write_kept_level_${N}(Edit &edit) {
  uint64_t count = 0;
  const uint32_t *const cells = edit.kept(${N}, count);
  return count == 0 ? 0 : write_level_${N}(edit, cells, count);
}

uint32_t change_level_${N}(Edit &edit, uint32_t old, Voxel low) {
  bool differs = false;
  auto change = [&](Voxel cell, Voxel corner) {
    const auto number = static_cast<uint32_t>(LEVEL_${N}_SHAPE.index(cell));
    const uint32_t before = edit.cell(${N}, old, number);
    const uint32_t after = edit_${NEXT}(edit, before, corner);
    differs |= after != before;
    if (after != before)
      edit.keep(${N}, number, after);
  };
  for_each_edited_cell<LEVEL_${N}_SHAPE>(edit, low, {}, LEVEL_${N}_SHAPE.longest(), change);
  uint32_t changed = old;
  if (differs) {
    edit.keep_others(${N}, old);
    changed = write_kept_level_${N}(edit);
  }
  edit.drop(${N});
  return changed;
}

// A sub-volume of voxels of one value.
uint32_t fill_level_${N}(Edit &edit, uint32_t value) {
  const uint32_t cell = filled_${NEXT}(edit, value);
  for (uint64_t number = 0; number < LEVEL_${N}_SHAPE.cells(); ++number)
    edit.keep(${N}, static_cast<uint32_t>(number), cell);
  const uint32_t offset = write_kept_level_${N}(edit);
  edit.drop(${N});
  return offset;
}
