bool intersect_level(const Ray ray, inout Traversal traversal, uint grid) {
  ivec3 begin = traversal.cell;
  while (LEVEL_FIRST ? goes_on(traversal) : within_level(begin, traversal.cell)) {
    count_lookup(traversal);
    EmptySpan span = EmptySpan(LEVEL_LOG2_CELL, 1);
    uint value = look_up_level(ray, grid, traversal.cell >> LEVEL_LOG2_CELL, span);
    if (LEVEL_LOOK_UP_MAY_BE_CUT && value == 0u && span.count == 0)
      continue; // The device ended the look-up.
    if (value == 0u) {
      if (LEVEL_MARCHES)
        march_level(ray, traversal, span.count);
      else if (LEVEL_ONE_VOXEL_STEPS)
        step_over_voxel(ray, traversal);
      else
        step_over(ray, traversal, span);
    } else if (LEVEL_STOPS && small_height(ray, traversal) >= LEVEL_LOG2_CELL) {
      return COLOUR ? stop_with(traversal, sample_next(value)) : true;
    } else if (intersect_next(ray, traversal, value)) {
      return true;
    }
  }
  return false;
}
