// A tree of depth 0 is one leaf.
bool intersect_level(const Ray ray, inout Traversal traversal, uint leaf) {
  count_lookup(traversal);
  if (LEVEL_STOPS && small_height(ray, traversal) >= LEVEL_LOG2_CELL)
    return COLOUR ? stop_with(traversal, sample_next(load_word(leaf))) : true;
  return intersect_next(ray, traversal, leaf_level(leaf));
}
