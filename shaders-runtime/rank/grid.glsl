// How many voxels of the grid come before one. Where traversals stop above voxels, one may not be there.
uint rank_level(uint grid, ivec3 voxel) {
  if (LEVEL_LAST)
    return !CONE || is_there_level(grid, voxel) ? voxels_before_level(grid, voxel) : 0u;
  uint rank = 0u;
  uint value = ranked_value_level(grid, voxel >> LEVEL_LOG2_CELL, rank);
  return CONE && value == 0u ? 0u : rank + rank_next(value, voxel);
}
