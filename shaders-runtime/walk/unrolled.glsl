// In a node of 2^H cells a side: child after child along the ray, each of 2^(H - 1) cells a side.
bool intersect_NODE(const Ray ray, inout Walk walk, uint node, ivec3 low) {
  const int side = LEVEL_N_LOG2_CELL + H - 1;
  ivec3 place = (walk.cell - low) >> side;
  while (in_grid(place, ivec3(1))) {
#ifdef CONE
    // What did not look small when this node was entered may do so now: its parent stops at it.
    int small = small_height(ray, walk) - LEVEL_N_LOG2_CELL;
    if (small >= H && H < LEVEL_N_DEPTH)
      return false;
#endif
    bool leaf = false;
    uint child = KIND_child(node, child_index(place, 0), leaf);
    bool last = child == 0u || leaf;
#ifdef CONE
    last = last || small >= H - 1;
#endif
    if (last)
      count_lookup(walk);
    ivec3 corner = low + (place << side);
    if (child == 0u)
      step_over(ray, walk, corner, 1 << side);
#ifdef CONE
    else if (small >= (leaf ? 0 : H - 1))
      return stop_with(walk, sample_level_N_node(child, leaf));
#endif
#ifdef INNER
    else if (!leaf) {
      if (intersect_CHILD(ray, walk, child, corner))
        return true;
    }
#endif
    else {
      ivec3 cell = (walk.cell - low) >> LEVEL_N_LOG2_CELL;
      if (intersect_NEXT(ray, walk, load_word(child), low + (cell << LEVEL_N_LOG2_CELL)))
        return true;
    }
    place = (walk.cell - low) >> side;
  }
  return false;
}
