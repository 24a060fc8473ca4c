// How many voxels of the tree come before one.
uint rank_level(uint root, ivec3 voxel) {
  ivec3 at = voxel >> LEVEL_LOG2_CELL;
  uint node = root;
  uint rank = 0u;
  bool leaf = false;
${LAYERS_DOWN}  // All that come before it are counted, in this level.
%if last
  return rank;
%else
  return node == 0u ? rank : rank + rank_next(${leaf-node}, voxel);
%end
}
