// The voxel around a cell, from this tree down; 0, and what is empty there with its faces ahead, if there is none.
uint locate_level(const Ray ray, uint root, ivec3 cell, inout EmptySpan span, inout real3 face) {
  ivec3 at = cell >> LEVEL_LOG2_CELL;
  uint node = root;
  bool leaf = false;
  int around = 0;
  [[unroll]] for (int layer = LEVEL_DEPTH - 1; layer >= 0; layer--)
    if (node != 0u && !leaf) {
      node = descend_level(node, at, layer * LEVEL_BRANCH, leaf, around);
      span = EmptySpan(LEVEL_LOG2_CELL + layer * LEVEL_BRANCH + (LEVEL_WIDE ? around : 0), 1);
    }
  if (REPORTS_FACES && node == 0u)
    face = real3(faces_ahead(ray, cell, span));
  if (LEVEL_LAST)
    return node == 0u ? 0u : leaf_level(node);
  return node == 0u ? 0u : locate_next(ray, leaf_level(node), cell, span, face);
}
