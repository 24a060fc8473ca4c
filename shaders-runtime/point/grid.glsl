// Whether there is a voxel, in this grid.
bool is_voxel_level_${N}(uint grid, ivec3 voxel) {
  uint value = cell_level_${N}(grid, voxel >> LEVEL_${N}_LOG2_CELL);
%if last
  return value != 0u;
%else
  return value != 0u && is_voxel_${NEXT}(value, voxel);
%end
}
