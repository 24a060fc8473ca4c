bool intersect_level(const Ray ray, inout Walk walk, uint grid) {
  ivec3 begin = walk.cell;
  while (LEVEL_FIRST ? goes_on(walk) : within_level(begin, walk.cell)) {
    count_lookup(walk);
    Gap gap = Gap(LEVEL_LOG2_CELL, 1);
    uint value = look_up_level(ray, grid, walk.cell >> LEVEL_LOG2_CELL, gap);
    if (LEVEL_LOOK_UP_MAY_BE_CUT && value == 0u && gap.count == 0)
      continue; // The device ended the look-up.
    if (value == 0u) {
      if (LEVEL_MARCHES)
        march_level(ray, walk, gap.count);
      else if (LEVEL_ONE_VOXEL_STEPS)
        step_over_voxel(ray, walk);
      else
        step_over(ray, walk, gap);
    } else if (LEVEL_STOPS && small_height(ray, walk) >= LEVEL_LOG2_CELL) {
      return COLOUR ? stop_with(walk, sample_next(value)) : true;
    } else if (intersect_next(ray, walk, value)) {
      return true;
    }
  }
  return false;
}
