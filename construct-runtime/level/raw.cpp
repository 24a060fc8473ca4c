uint32_t construct_level_N(Build &build, Voxel low) {
  uint32_t *grid = nullptr;
  auto construct_cell = [&](GridCell cell) {
    const uint32_t value = construct_NEXT(build, cell.low);
    if (value != 0 && (grid || (grid = build.allocate(LEVEL_N_SIZE.cells()))))
      grid[cell.index] = value;
  };
  for_each_cell(build, low, LEVEL_N_SIZE, LEVEL_N_LOG2_CELL, {}, LEVEL_N_SIZE.longest(), construct_cell);
  if (!grid)
    return 0;
  const uint32_t offset = build.append(grid, LEVEL_N_SIZE.cells());
  build.release(grid);
  return offset;
}
