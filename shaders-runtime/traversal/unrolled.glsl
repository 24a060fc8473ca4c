bool intersect_level(const Ray ray, inout Traversal traversal, uint root) {
  ivec3 begin = traversal.cell;
  while (LEVEL_FIRST ? goes_on(traversal) : within_level(begin, traversal.cell)) {
    bool leaf;
    uint found = seek_level_highest(ray, traversal, root, leaf);
    if (LEVEL_STOPS && found != 0u && (!leaf || small_height(ray, traversal) >= LEVEL_LOG2_CELL))
      return COLOUR ? stop_with(traversal, sample_level_node(found, leaf)) : true;
    if (found != 0u && intersect_next(ray, traversal, leaf_level(found)))
      return true;
  }
  return false;
}
