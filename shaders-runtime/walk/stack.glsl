// path[i] is the node i layers above the cells around the walk's cell: a step climbs only to the ancestor of the old cell
// and the new.
%if stack-shared
shared uint path_level[LEVEL_DEPTH + 1][gl_WorkGroupSize.x];

%end
bool intersect_level(const Ray ray, inout Walk walk, uint root) {
%if stack-shared
%else
  uint path[LEVEL_DEPTH + 1];
%end
  ${path}[LEVEL_DEPTH]${of-ray} = root;
  int top = LEVEL_DEPTH;
  for (;;) {
    // Down to the leaf, or the empty child, `layer` layers above the cells.
    count_lookup(walk);
    ivec3 cell = walk.cell >> LEVEL_LOG2_CELL;
    int small = LEVEL_STOPS ? small_height(ray, walk) - LEVEL_LOG2_CELL : 0;
    int stop = clamp(small / LEVEL_BRANCH, 0, LEVEL_DEPTH - 1);
    if (LEVEL_STOPS)
      top = max(top, stop + 1);
    uint node = ${path}[top]${of-ray};
    int layer = top;
    bool leaf = false;
%if wide
    int around = 0;
%end
    while (node != 0u && !leaf && (!LEVEL_STOPS || layer > stop)) {
      ${path}[layer]${of-ray} = node;
      layer--;
      node = child_level(node, cell, layer * LEVEL_BRANCH, leaf${around});
    }
    ivec3 before = walk.cell;
    if (node == 0u)
      step_over(ray, walk, LEVEL_LOG2_CELL + layer * LEVEL_BRANCH${plus-around});
    else if (LEVEL_STOPS && (leaf ? small >= 0 : layer == stop))
      return COLOUR ? stop_with(walk, sample_level_node(node, leaf)) : true;
    else if (leaf && intersect_next(ray, walk, ${leaf-node}))
      return true;

    if (LEVEL_FIRST && !goes_on(walk))
      return false;
    ivec3 changed = before ^ walk.cell;
    int highest = findMSB(uint(changed.x | changed.y | changed.z));
    if (!LEVEL_FIRST && highest >= LEVEL_LOG2_SIDE)
      return false;
    top = max(layer, (highest - LEVEL_LOG2_CELL) / LEVEL_BRANCH) + 1;
  }
}
