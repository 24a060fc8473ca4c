// False of an empty cell, where a traversal may stop that takes what is around for one.
bool is_there_level(uint grid, ivec3 cell) {
  ivec3 at = cell & ((ivec3(1) << LEVEL_LOG2_SIZE) - 1);
  uint number = uint(at.x + ((at.y + (at.z << LEVEL_LOG2_SIZE.y)) << LEVEL_LOG2_SIZE.x));
  return (load_word_at(grid, (LEVEL_COUNTS ? 2u : 1u) * (number >> 5)) >> (number & 31u) & 1u) != 0u;
}
