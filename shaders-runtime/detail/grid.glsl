// The colour of a voxel of the grid. 0 if the device cut the search short.
uint sample_level(uint grid) {
  uint value = any_value_level(grid);
  return value == 0u ? 0u : sample_next(value);
}
