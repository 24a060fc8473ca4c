// Whether there is a voxel, in this tree.
bool is_voxel_level(uint root, ivec3 voxel) {
  ivec3 at = voxel >> LEVEL_LOG2_CELL;
  uint node = root;
  bool leaf = false;
  int around = 0;
  [[unroll]] for (int layer = LEVEL_DEPTH - 1; layer >= 0; layer--)
    if (node != 0u && !leaf)
      node = descend_level(node, at, layer * LEVEL_BRANCH, leaf, around);
  return node != 0u && (LEVEL_LAST || is_voxel_next(leaf_level(node), voxel));
}
