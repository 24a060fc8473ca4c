// What a voxel is: here its value is its colour.
uint colour_of(const Walk walk) {
  if (VALUES_APART)
    return value_of_rank(rank_level_1(load_word(0u), walk.cell));
  if (DEFERS_VALUES && LOWEST_FINDS_VALUES_LATER)
    return value_lowest(walk.voxel, walk.cell);
  return DEFERS_VALUES && LOWEST_HAS_LEAF_WORDS ? load_word(walk.voxel) : walk.voxel;
}
