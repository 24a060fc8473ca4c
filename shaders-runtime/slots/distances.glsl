// What the word of a distance says: its cells, or those along the largest empty cube ahead.
INLINE int distance_level(const Ray ray, uint word) {
  return int(LEVEL_DISTANCES_OF_OCTANTS ? word >> (ray.octant * LEVEL_FIELD_BITS) & LEVEL_FIELD_MASK : word & 0x7fffffffu);
}

// The value of a cell, or 0 if it is empty; `span` then counts the cells of its distance.
uint look_up_level(const Ray ray, uint grid, ivec3 cell, inout EmptySpan span) {
  uint granule = GRANULES ? granule_level(grid, cell) : grid;
  uint slot = slot_level(grid, cell);
  uint word = load_word_from(granule, slot);
  if (LEVEL_DISTANCES_BESIDE) {
    // The distance stands behind the value.
    uint skip = word == 0u ? load_word_from(granule, slot + 1u) : 0u;
    span.count = distance_level(ray, skip);
  } else {
    span.count = distance_level(ray, word);
  }
  return value_in_level(word);
}
