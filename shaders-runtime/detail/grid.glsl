// The colour of a voxel of the grid: that of the first cell that is not empty, taken in an order that jumps about, so
// that a surface is met soon wherever it lies. 0 if the device cut the search short.
uint sample_level_N(uint grid) {
  int count = 1 << (LEVEL_N_LOG2_SIZE.x + LEVEL_N_LOG2_SIZE.y + LEVEL_N_LOG2_SIZE.z);
  uint value = 0u;
  for (int i = 0; i < count && value == 0u; i++) {
    // An odd factor visits every cell once; this one steps by 0.61 of 4096 cells.
    int at = i * 2481 & (count - 1);
    ivec3 cell = ivec3(at, at >> LEVEL_N_LOG2_SIZE.x, at >> (LEVEL_N_LOG2_SIZE.x + LEVEL_N_LOG2_SIZE.y));
    value = KIND_value(grid, cell & ((ivec3(1) << LEVEL_N_LOG2_SIZE) - 1), LEVEL_N_LOG2_SIZE);
  }
  return value == 0u ? 0u : sample_NEXT(value);
}

