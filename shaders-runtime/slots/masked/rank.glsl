// How many cells that are not empty come before one.
uint bits_before_level(uint grid, ivec3 cell) {
  ivec3 at = cell & ((ivec3(1) << LEVEL_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y + (at.z << LEVEL_LOG2_SIZE.y)) << LEVEL_LOG2_SIZE.x));
  uint lower = (1u << (number & 31u)) - 1u;
  if (LEVEL_COUNTS) {
    uint place = place_of_word(grid, 2u * (number >> 5));
    return load_word_from(grid, place + 1u) + uint(bitCount(load_word_from(grid, place) & lower));
  }
  uint before = number < 32u ? 0u : uint(bitCount(load_word(grid)));
  return before + uint(bitCount(load_word_at(grid, (number >> 5)) & lower));
}

// Of voxels these are all that come before one.
INLINE uint voxels_before_level(uint grid, ivec3 cell) { return bits_before_level(grid, cell); }
