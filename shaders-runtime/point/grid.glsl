// Whether there is a voxel, in this grid.
bool is_voxel_level(uint grid, ivec3 voxel) {
  uint value = cell_level(grid, voxel >> LEVEL_LOG2_CELL);
  return value != 0u && (LEVEL_LAST || is_voxel_next(value, voxel));
}
