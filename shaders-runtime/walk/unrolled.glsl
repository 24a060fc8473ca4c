bool intersect_level(const Ray ray, inout Walk walk, uint root) {
  ivec3 begin = walk.cell;
  while (LEVEL_FIRST ? goes_on(walk) : within_level(begin, walk.cell)) {
    bool leaf;
    uint found = seek_level_highest(ray, walk, root, leaf);
    if (LEVEL_STOPS && found != 0u && (!leaf || small_height(ray, walk) >= LEVEL_LOG2_CELL))
      return COLOUR ? stop_with(walk, sample_level_node(found, leaf)) : true;
    if (found != 0u && intersect_next(ray, walk, leaf_level(found)))
      return true;
  }
  return false;
}
