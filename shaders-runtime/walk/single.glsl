// A tree of depth 0 is one leaf.
bool intersect_level_N(const Ray ray, inout Walk walk, uint leaf, ivec3 low) {
  count_lookup(walk);
  return intersect_NEXT(ray, walk, load_word(leaf), low);
}
