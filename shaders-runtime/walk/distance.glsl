bool intersect_level_N(const Ray ray, inout Walk walk, uint grid, ivec3 low) {
  ivec3 cell = (walk.cell - low) >> LEVEL_N_LOG2_CELL;
  while (in_grid(cell, LEVEL_N_LOG2_SIZE)) {
    count_lookup(walk);
    uint entry = KIND_entry(grid, cell, LEVEL_N_LOG2_SIZE);
    uint value = load_word(entry);
    if (value == 0u)
      march(ray, walk, low, cell, LEVEL_N_LOG2_SIZE, LEVEL_N_LOG2_CELL, load_word(entry + 1u));
#ifdef CONE
    else if (small_height(ray, walk) >= LEVEL_N_LOG2_CELL)
      return stop_with(walk, sample_NEXT(value));
#endif
    else if (intersect_NEXT(ray, walk, value, low + (cell << LEVEL_N_LOG2_CELL)))
      return true;
    cell = (walk.cell - low) >> LEVEL_N_LOG2_CELL;
  }
  return false;
}
