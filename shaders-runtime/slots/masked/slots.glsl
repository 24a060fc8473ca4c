// The value of the cell that is not empty after so many others.
uint value_of_slot_level(uint grid, uint slot) { return load_word_at(grid, LEVEL_HEAD_WORDS + LEVEL_SLOT_WORDS * slot); }

// The value of a cell that is not empty. Adds to `rank` how many voxels of the grid come before those of the cell, which stands
// behind the value.
uint ranked_value_level(uint grid, ivec3 cell, inout uint rank) {
  if (CONE && !is_there_level(grid, cell))
    return 0u;
  uint slot = bits_before_level(grid, cell);
  rank += load_word_at(grid, LEVEL_HEAD_WORDS + LEVEL_SLOT_WORDS * slot + 1u);
  return value_of_slot_level(grid, slot);
}
