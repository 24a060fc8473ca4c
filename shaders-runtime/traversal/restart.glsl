bool intersect_level(const Ray ray, inout Traversal traversal, uint root) {
  ivec3 begin = traversal.cell;
  while (LEVEL_FIRST ? goes_on(traversal) : within_level(begin, traversal.cell)) {
    // Down from the root to the leaf, or the empty child, `layer` layers above the cells.
    count_lookup(traversal);
    ivec3 cell = traversal.cell >> LEVEL_LOG2_CELL;
    uint node = root;
    int layer = LEVEL_DEPTH;
    bool leaf = false;
    int around = 0;
    int small = LEVEL_STOPS ? small_height(ray, traversal) - LEVEL_LOG2_CELL : 0;
    int stop = clamp(small / LEVEL_BRANCH, 0, LEVEL_DEPTH - 1);
    while (node != 0u && !leaf && (!LEVEL_STOPS || layer > stop)) {
      layer--;
      node = descend_level(node, cell, layer * LEVEL_BRANCH, leaf, around);
    }
    if (node == 0u)
      step_over(ray, traversal, LEVEL_LOG2_CELL + layer * LEVEL_BRANCH + (LEVEL_WIDE ? around : 0));
    else if (LEVEL_STOPS && (leaf ? small >= 0 : layer == stop))
      return COLOUR ? stop_with(traversal, sample_level_node(node, leaf)) : true;
    else if (leaf && intersect_next(ray, traversal, leaf_level(node)))
      return true;
  }
  return false;
}
