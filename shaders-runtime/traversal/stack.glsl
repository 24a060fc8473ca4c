// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the old cell
// and the new.
bool intersect_level(const Ray ray, inout Traversal traversal, uint root) {
  uint path[LEVEL_DEPTH + 1];
  path[LEVEL_DEPTH] = root;
  int top = LEVEL_DEPTH;
  for (;;) {
    // Down to the leaf, or the empty child, `layer` layers above the cells.
    count_lookup(traversal);
    ivec3 cell = traversal.cell >> LEVEL_LOG2_CELL;
    int small = LEVEL_STOPS ? small_height(ray, traversal) - LEVEL_LOG2_CELL : 0;
    int stop = clamp(small / LEVEL_BRANCH, 0, LEVEL_DEPTH - 1);
    if (LEVEL_STOPS)
      top = max(top, stop + 1);
    uint node = path[top];
    int layer = top;
    bool leaf = false;
    int around = 0;
    while (node != 0u && !leaf && (!LEVEL_STOPS || layer > stop)) {
      path[layer] = node;
      layer--;
      node = descend_level(node, cell, layer * LEVEL_BRANCH, leaf, around);
    }
    ivec3 before = traversal.cell;
    if (node == 0u)
      step_over(ray, traversal, LEVEL_LOG2_CELL + layer * LEVEL_BRANCH + (LEVEL_WIDE ? around : 0));
    else if (LEVEL_STOPS && (leaf ? small >= 0 : layer == stop))
      return COLOUR ? stop_with(traversal, sample_level_node(node, leaf)) : true;
    else if (leaf && intersect_next(ray, traversal, leaf_level(node)))
      return true;

    if (LEVEL_FIRST && !goes_on(traversal))
      return false;
    ivec3 changed = before ^ traversal.cell;
    int highest = findMSB(uint(changed.x | changed.y | changed.z));
    if (!LEVEL_FIRST && highest >= LEVEL_LOG2_SIDE)
      return false;
    top = max(layer, (highest - LEVEL_LOG2_CELL) / LEVEL_BRANCH) + 1;
  }
}
