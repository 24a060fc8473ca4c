// A tree of depth 0 is one leaf.
bool intersect_level_N(const Ray ray, inout Walk walk, uint leaf, ivec3 low) {
  count_lookup(walk);
#ifdef CONE
  if (small_height(ray, walk) >= LEVEL_N_LOG2_CELL)
    return stop_with(walk, sample_NEXT(load_word(leaf)));
#endif
  return intersect_NEXT(ray, walk, load_word(leaf), low);
}
