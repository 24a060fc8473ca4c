// The bits of one axis of a cell's number, from bit `at` on: those that count granules, and those that count slots in one.
INLINE int granules_of(int axis, int bits, int at) {
  return at + bits <= LOG2_GRANULE ? 0 : at < LOG2_GRANULE ? axis >> (LOG2_GRANULE - at) : axis << (at - LOG2_GRANULE);
}
INLINE int slots_of(int axis, int bits, int at) {
  return at >= LOG2_GRANULE ? 0 : at + bits <= LOG2_GRANULE ? axis << at : (axis & ((1 << (LOG2_GRANULE - at)) - 1)) << at;
}

// The granule in which a cell's slot is.
uint granule_level(uint grid, ivec3 cell) {
  ivec3 at = LEVEL_FIRST ? cell : cell & ((ivec3(1) << LEVEL_LOG2_SIZE) - 1);
  int granule = granules_of(at.x, LEVEL_BITS_OF_X, 0) | granules_of(at.y, LEVEL_BITS_OF_Y, LEVEL_BITS_OF_X) |
                granules_of(at.z, LEVEL_BITS_OF_Z, LEVEL_BITS_OF_X + LEVEL_BITS_OF_Y);
  return grid + LEVEL_SLOT_WORDS * uint(granule);
}

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
uint slot_level(uint grid, ivec3 cell) {
  ivec3 at = LEVEL_FIRST ? cell : cell & ((ivec3(1) << LEVEL_LOG2_SIZE) - 1);
  if (GRANULES) {
    int slot = slots_of(at.x, LEVEL_BITS_OF_X, 0) | slots_of(at.y, LEVEL_BITS_OF_Y, LEVEL_BITS_OF_X) |
               slots_of(at.z, LEVEL_BITS_OF_Z, LEVEL_BITS_OF_X + LEVEL_BITS_OF_Y);
    return LEVEL_SLOT_WORDS * uint(slot);
  }
  return grid + LEVEL_SLOT_WORDS * uint(at.x + ((at.y + (at.z << LEVEL_LOG2_SIZE.y)) << LEVEL_LOG2_SIZE.x));
}

// A slot that has its distance in it is empty if it has no alpha, a number in its lowest field, or its highest bit.
INLINE bool is_empty_level(uint word) {
  return LEVEL_EMPTY_BY_ALPHA         ? (word >> 24) == 0u
         : LEVEL_DISTANCES_OF_OCTANTS ? (word & LEVEL_FIELD_MASK) != 0u
                                      : (word >> 31) != 0u;
}

// The value in a slot, or 0 if its cell is empty.
uint value_level(uint word) { return is_empty_level(word) ? 0u : word >> LEVEL_TAG_SHIFT; }
INLINE uint value_in_level(uint word) { return LEVEL_DISTANCES_IN_SLOT ? value_level(word) : word; }

// The value of a cell, or 0 if it is empty.
uint cell_level(uint grid, ivec3 cell) {
  uint granule = GRANULES ? granule_level(grid, cell) : grid;
  uint slot = slot_level(grid, cell);
  return value_in_level(load_word_from(granule, slot));
}

// The value of a cell that is not empty. Adds to `rank` how many voxels of the grid come before those of the cell, which stands last
// in its slot.
uint ranked_value_level(uint grid, ivec3 cell, inout uint rank) {
  uint granule = GRANULES ? granule_level(grid, cell) : grid;
  uint slot = slot_level(grid, cell);
  rank += load_word_from(granule, slot + LEVEL_SLOT_WORDS - 1u);
  return value_in_level(load_word_from(granule, slot));
}

// The first value of the grid in an order that jumps about, so that a surface is met soon wherever it lies. 0 if the
// device cut the search short.
uint any_value_level(uint grid) {
  int count = 1 << (LEVEL_LOG2_SIZE.x + LEVEL_LOG2_SIZE.y + LEVEL_LOG2_SIZE.z);
  uint value = 0u;
  for (int i = 0; i < count && value == 0u; i++) {
    // An odd factor visits every cell once; this one steps by 0.61 of 4096 cells.
    int at = i * 2481 & (count - 1);
    ivec3 cell = ivec3(at, at >> LEVEL_LOG2_SIZE.x, at >> (LEVEL_LOG2_SIZE.x + LEVEL_LOG2_SIZE.y));
    value = cell_level(grid, cell & ((ivec3(1) << LEVEL_LOG2_SIZE) - 1));
  }
  return value;
}
