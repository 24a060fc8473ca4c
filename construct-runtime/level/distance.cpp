// Lowers each cell's distance to one more than that of its neighbour `stride` entries back, along an axis of 2^log2
// cells, and then of its neighbour ahead.
void sweep_level_N(uint32_t *grid, uint64_t stride, int log2) {
  const auto lower = [&](uint64_t cell, uint64_t neighbour) {
    // Never beyond the reach, so that adding 1 cannot wrap.
    if (grid[2 * neighbour + 1] < LEVEL_N_REACH && grid[2 * neighbour + 1] + 1 < grid[2 * cell + 1])
      grid[2 * cell + 1] = grid[2 * neighbour + 1] + 1;
  };
  const uint64_t cells = LEVEL_N_SIZE.cells();
  const uint64_t length = uint64_t{1} << log2;
  for (uint64_t cell = stride; cell < cells; ++cell)
    if (cell / stride % length != 0)
      lower(cell, cell - stride);
  for (uint64_t cell = cells - stride; cell-- > 0;)
    if (cell / stride % length != length - 1)
      lower(cell, cell + stride);
}

// L1 distances are separable: two sweeps an axis make them exact up to the reach.
void measure_level_N(uint32_t *grid) {
  for (uint64_t cell = 0; cell < LEVEL_N_SIZE.cells(); ++cell)
    grid[2 * cell + 1] = grid[2 * cell] != 0 ? 0 : LEVEL_N_REACH;
  sweep_level_N(grid, 1, LEVEL_N_SIZE.x);
  sweep_level_N(grid, uint64_t{1} << LEVEL_N_SIZE.x, LEVEL_N_SIZE.y);
  sweep_level_N(grid, uint64_t{1} << (LEVEL_N_SIZE.x + LEVEL_N_SIZE.y), LEVEL_N_SIZE.z);
}

uint32_t construct_level_N(Build &build, Voxel low) {
  uint32_t *grid = nullptr; // Two words a cell: terminating integer, distance.
  auto construct_cell = [&](GridCell cell) {
    const uint32_t value = construct_NEXT(build, cell.low);
    if (value != 0 && (grid || (grid = build.allocate(2 * LEVEL_N_SIZE.cells()))))
      grid[2 * cell.index] = value;
  };
  for_each_cell(build, low, LEVEL_N_SIZE, LEVEL_N_LOG2_CELL, {}, LEVEL_N_SIZE.longest(), construct_cell);
  if (!grid)
    return 0;
  measure_level_N(grid);
  const uint32_t offset = build.append(grid, 2 * LEVEL_N_SIZE.cells());
  build.release(grid);
  return offset;
}
