// How many voxels of the grid come before one.
uint rank_level(uint grid, ivec3 voxel) {
%if last
%if cone
  return is_there_level(grid, voxel) ? voxels_before_level(grid, voxel) : 0u;
%else
  return voxels_before_level(grid, voxel);
%end
%else
  uint rank = 0u;
  uint value = ranked_value_level(grid, voxel >> LEVEL_LOG2_CELL, rank);
%if cone
  return value == 0u ? 0u : rank + rank_next(value, voxel);
%else
  return rank + rank_next(value, voxel);
%end
%end
}
