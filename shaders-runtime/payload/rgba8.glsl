// What a voxel is: here its value is its colour.
uint colour_of(const Traversal traversal) {
  if (VALUES_APART)
    return value_of_rank(rank_level_1(load_word(0u), traversal.cell));
  if (DEFERS_VALUES && LOWEST_DEFERS_VALUES)
    return value_lowest(traversal.voxel, traversal.cell);
  return DEFERS_VALUES && LOWEST_HAS_LEAF_WORDS ? load_word(traversal.voxel) : traversal.voxel;
}
