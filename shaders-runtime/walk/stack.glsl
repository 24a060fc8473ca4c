// path[h] is the node of 2^h cells a side around the cell: a step climbs only to the ancestor of the old and the new.
bool intersect_level_N(const Ray ray, inout Walk walk, uint root, ivec3 low) {
  uint path[LEVEL_N_DEPTH + 1];
  path[LEVEL_N_DEPTH] = root;
  int height = LEVEL_N_DEPTH;
  ivec3 cell = (walk.cell - low) >> LEVEL_N_LOG2_CELL;
  for (;;) {
    // Down to the leaf, or the empty child, of 2^side cells a side around the cell.
    count_lookup(walk);
#ifdef CONE
    int small = small_height(ray, walk) - LEVEL_N_LOG2_CELL;
    int stop = clamp(small, 0, LEVEL_N_DEPTH - 1);
    height = max(height, stop + 1);
#endif
    uint node = path[height];
    int side = height;
    bool leaf = false;
#ifdef CONE
    while (node != 0u && !leaf && side > stop) {
#else
    while (node != 0u && !leaf) {
#endif
      path[side] = node;
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

    ivec3 next = (walk.cell - low) >> LEVEL_N_LOG2_CELL;
    if (!in_grid(next, ivec3(LEVEL_N_DEPTH)))
      return false;
    ivec3 changed = cell ^ next;
    height = max(side, findMSB(changed.x | changed.y | changed.z)) + 1;
    cell = next;
  }
}
