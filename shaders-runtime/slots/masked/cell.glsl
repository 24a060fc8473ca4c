// The value of a cell, or 0 if it is empty.
uint cell_level(uint grid, ivec3 cell) {
  ivec3 at = LEVEL_FIRST ? cell : cell & ((ivec3(1) << LEVEL_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y + (at.z << LEVEL_LOG2_SIZE.y)) << LEVEL_LOG2_SIZE.x));
  uint bit = 1u << (number & 31u);
  if (LEVEL_ALIKE)
    return (load_word_at(grid, LEVEL_COUNTS ? 2u * (number >> 5) : (number >> 5)) & bit) != 0u ? OCCUPIED : 0u;
  uint mask = load_word_at(grid, LEVEL_COUNTS ? 2u * (number >> 5) : (number >> 5));
  if ((mask & bit) == 0u)
    return 0u;
  uint rank = uint(bitCount(mask & (bit - 1u)));
  if (LEVEL_COUNTS) // Each word of the mask is followed by how many bits the words before it have.
    rank += load_word_at(grid, 2u * (number >> 5) + 1u);
  else if (number >= 32u)
    rank += uint(bitCount(load_word(grid)));
  return value_of_slot_level(grid, rank);
}

// The first value of the grid.
uint any_value_level(uint grid) { return LEVEL_IMPLIED ? OCCUPIED : value_of_slot_level(grid, 0u); }
