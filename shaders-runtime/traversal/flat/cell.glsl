void look_up_layer_level(const Ray ray, ivec3 cell, inout uint node, inout int layer, inout Lowest lowest, inout EmptySpan span,
                         inout uint value) {
  if (LEVEL_LAST || layer < LEVEL_END) {
    span = EmptySpan(LEVEL_LOG2_CELL, 1);
    if (LEVEL_GRID)
      node = look_up_level(ray, node, cell >> LEVEL_LOG2_CELL, span);
    else
      node = leaf_level(node); // A tree of depth 0 is one leaf.
    if (LEVEL_LAST) {
      value = node;
      node = 0u;
    } else {
      layer += node != 0u ? 1 : 0;
    }
  } else {
    look_up_layer_next(ray, cell, node, layer, lowest, span, value);
  }
}
