uint32_t construct_level_N(Build &build, Voxel low) {
  uint32_t *grid = nullptr;
  auto place = [&](Voxel cell, uint32_t value) {
    if (grid || (grid = build.allocate(N, LEVEL_N_SHAPE.cells())))
      grid[LEVEL_N_SHAPE.index(cell)] = value;
  };
  for_each_cell<LEVEL_N_SHAPE, construct_NEXT>(build, low, {}, LEVEL_N_SHAPE.longest(), place);
  if (!grid)
    return 0;
  const uint64_t words = LEVEL_N_SHAPE.cells();
  const uint32_t offset = LEVEL_N_SHARES_GRIDS ? build.intern(N, grid, words) : build.append(N, grid, words);
  build.release(N);
  return offset;
}
