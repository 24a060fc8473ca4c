void look_up_layer_level(const Ray ray, ivec3 cell, inout uint node, inout int layer, inout Lowest lowest, inout EmptySpan span,
                         inout uint value) {
  if (LEVEL_LAST || layer < LEVEL_END) {
    bool leaf = false;
    int below = LEVEL_END - 1 - layer;
    int around = 0;
    node = descend_level(node, cell >> LEVEL_LOG2_CELL, below * LEVEL_BRANCH, leaf, around);
    span = EmptySpan(LEVEL_LOG2_CELL + below * LEVEL_BRANCH + (LEVEL_WIDE ? around : 0), 1);
    if (!LEVEL_LAST)
      lowest.layer[LEVEL_INDEX] = layer;
    if (node != 0u && !leaf) {
      layer++;
    } else if (node != 0u) {
      if (LEVEL_LAST) {
        value = leaf_level(node);
        node = 0u;
      } else {
        node = leaf_level(node);
        layer = LEVEL_END;
      }
    }
  } else {
    look_up_layer_next(ray, cell, node, layer, lowest, span, value);
  }
}
