// How many voxels of the tree come before one.
uint rank_level_${N}(uint root, ivec3 voxel) {
  ivec3 at = voxel >> LEVEL_${N}_LOG2_CELL;
  uint node = root;
  uint rank = 0u;
  bool leaf = false;
${LAYERS_DOWN}  // All that come before it are counted, in this level.
%if last
  return rank;
%else
  return node == 0u ? rank : rank + rank_${NEXT}(${leaf-node}, voxel);
%end
}
