// How many voxels of the grid come before one.
uint rank_level_${N}(uint grid, ivec3 voxel) {
%if last
%if cone
  return is_there_level_${N}(grid, voxel) ? voxels_before_level_${N}(grid, voxel) : 0u;
%else
  return voxels_before_level_${N}(grid, voxel);
%end
%else
  uint rank = 0u;
  uint value = ranked_value_level_${N}(grid, voxel >> LEVEL_${N}_LOG2_CELL, rank);
%if cone
  return value == 0u ? 0u : rank + rank_${NEXT}(value, voxel);
%else
  return rank + rank_${NEXT}(value, voxel);
%end
%end
}
