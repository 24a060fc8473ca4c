// What a voxel is: here its value is its colour.
uint colour_of(const Walk walk) {
  if (VALUES_APART)
    return value_of_rank(rank_level_1(load_word(0u), walk.cell));
  if (VALUE_LATER)
    return value_level_${LOWEST_LEVEL}(walk.voxel, walk.cell);
  return DEFERS_LEAF ? load_word(walk.voxel) : walk.voxel;
}
