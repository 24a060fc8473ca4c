bool intersect_level_N(const Ray ray, inout Walk walk, uint root, ivec3 low) {
  ivec3 cell = (walk.cell - low) >> LEVEL_N_LOG2_CELL;
  while (in_grid(cell, ivec3(LEVEL_N_DEPTH))) {
    // Down from the root to the leaf, or the empty child, of 2^side cells a side around the cell.
    count_lookup(walk);
    uint node = root;
    int side = LEVEL_N_DEPTH;
    bool leaf = false;
#ifdef CONE
    int small = small_height(ray, walk) - LEVEL_N_LOG2_CELL;
    int stop = clamp(small, 0, LEVEL_N_DEPTH - 1);
    while (node != 0u && !leaf && side > stop) {
#else
    while (node != 0u && !leaf) {
#endif
      side--;
      node = KIND_child(node, child_index(cell, side), leaf);
    }
    if (node == 0u)
      step_over(ray, walk, low + ((cell >> side) << (side + LEVEL_N_LOG2_CELL)), 1 << (side + LEVEL_N_LOG2_CELL));
#ifdef CONE
    else if (leaf ? small >= 0 : side == stop)
      return stop_with(walk, sample_level_N_node(node, leaf));
#endif
    else if (leaf && intersect_NEXT(ray, walk, load_word(node), low + (cell << LEVEL_N_LOG2_CELL)))
      return true;
    cell = (walk.cell - low) >> LEVEL_N_LOG2_CELL;
  }
  return false;
}
