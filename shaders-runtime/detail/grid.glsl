// The colour of a voxel of the grid. 0 if the device cut the search short.
uint sample_level_${N}(uint grid) {
  uint value = any_value_level_${N}(grid);
  return value == 0u ? 0u : sample_${NEXT}(value);
}

