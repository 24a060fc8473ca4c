// How many voxels of the tree come before one.
uint rank_level(uint root, ivec3 voxel) {
  ivec3 at = voxel >> LEVEL_LOG2_CELL;
  uint node = root;
  uint rank = 0u;
  bool leaf = false;
  [[unroll]] for (int layer = LEVEL_DEPTH - 1; layer >= 0; layer--)
    if (node != 0u && !leaf)
      node = ranked_child_level(node, at, layer * LEVEL_BRANCH, rank, leaf);
  // All that come before it are counted, in this level.
  return LEVEL_LAST || node == 0u ? rank : rank + rank_next(leaf_level(node), voxel);
}
