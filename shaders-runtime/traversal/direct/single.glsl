// A tree of depth 0 is one leaf.
uint locate_level(const Ray ray, uint leaf, ivec3 cell, inout EmptySpan span, inout real3 face) {
  return LEVEL_LAST ? leaf_level(leaf) : locate_next(ray, load_word(leaf), cell, span, face);
}
