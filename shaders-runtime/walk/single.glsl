// A tree of depth 0 is one leaf.
bool intersect_level(const Ray ray, inout Walk walk, uint leaf) {
  count_lookup(walk);
  if (LEVEL_STOPS && small_height(ray, walk) >= LEVEL_LOG2_CELL)
    return COLOUR ? stop_with(walk, sample_next(load_word(leaf))) : true;
  return intersect_next(ray, walk, leaf_level(leaf));
}
