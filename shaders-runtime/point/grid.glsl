// Whether there is a voxel, in this grid.
bool is_voxel_level(uint grid, ivec3 voxel) {
  uint value = cell_level(grid, voxel >> LEVEL_LOG2_CELL);
%if last
  return value != 0u;
%else
  return value != 0u && is_voxel_next(value, voxel);
%end
}
