bool intersect_level_N(const Ray ray, inout Walk walk, uint grid, ivec3 low) {
  ivec3 cell = (walk.cell - low) >> LEVEL_N_LOG2_CELL;
  while (in_grid(cell, LEVEL_N_LOG2_SIZE)) {
    count_lookup(walk);
    uint value = KIND_cell(grid, cell, LEVEL_N_LOG2_SIZE);
    ivec3 corner = low + (cell << LEVEL_N_LOG2_CELL);
    if (value == 0u)
      step_over(ray, walk, corner, 1 << LEVEL_N_LOG2_CELL);
#ifdef CONE
    else if (small_height(ray, walk) >= LEVEL_N_LOG2_CELL)
      return stop_with(walk, sample_NEXT(value));
#endif
    else if (intersect_NEXT(ray, walk, value, corner))
      return true;
    cell = (walk.cell - low) >> LEVEL_N_LOG2_CELL;
  }
  return false;
}
