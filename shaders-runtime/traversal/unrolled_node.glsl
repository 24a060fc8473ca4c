// Goes along the ray through a node of a layer, counted from the cells, child after child, to the first leaf, or to the first node
// that looks small, if some do; 0 if there is none.
uint seek_level_layer(const Ray ray, inout Traversal traversal, uint node, out bool leaf) {
  const int height = LEVEL_LOG2_CELL + (LEVEL_LAYER - 1) * LEVEL_BRANCH;
  ivec3 begin = traversal.cell;
  uint found = 0u;
  leaf = false;
  bool small = false;
  while (found == 0u && (!LEVEL_STOPS || !small) && is_same_cube(begin, traversal.cell, height + LEVEL_BRANCH)) {
    int around = 0;
    uint child = descend_level(node, traversal.cell, height, leaf, around);
    bool last = LEVEL_LAYER == 1 || child == 0u || leaf;
    int looks = LEVEL_STOPS ? small_height(ray, traversal) : 0;
    if (LEVEL_STOPS)
      last = last || looks >= height;
    if (last)
      count_lookup(traversal);
    if (child == 0u)
      step_over(ray, traversal, height + (LEVEL_WIDE ? around : 0));
    else if (LEVEL_LAYER > 1 && !last)
      found = seek_level_lower(ray, traversal, child, leaf);
    else
      found = child;
    // What did not look small when this node was entered may do so now: its parent stops at it.
    if (LEVEL_STOPS)
      small = found == 0u && LEVEL_LAYER < LEVEL_DEPTH && small_height(ray, traversal) >= height + LEVEL_BRANCH;
  }
  return found;
}
