bool intersect_level(const Ray ray, inout Walk walk, uint root) {
%if first
  while (goes_on(walk)) {
%else
  ivec3 begin = walk.cell;
  while (within_level(begin, walk.cell)) {
%end
    // Down from the root to the leaf, or the empty child, `layer` layers above the cells.
    count_lookup(walk);
    ivec3 cell = walk.cell >> LEVEL_LOG2_CELL;
    uint node = root;
    int layer = LEVEL_DEPTH;
    bool leaf = false;
%if wide
    int around = 0;
%end
%if stops
    int small = small_height(ray, walk) - LEVEL_LOG2_CELL;
    int stop = clamp(small${per-branch}, 0, LEVEL_DEPTH - 1);
    while (node != 0u && !leaf && layer > stop) {
%else
    while (node != 0u && !leaf) {
%end
      layer--;
      node = child_level(node, cell, layer${times-branch}, leaf${around});
    }
    if (node == 0u)
      step_over(ray, walk, LEVEL_LOG2_CELL + layer${times-branch}${plus-around});
%if stops
    else if (leaf ? small >= 0 : layer == stop)
%if colour
      return stop_with(walk, sample_level_node(node, leaf));
%else
      return true;
%end
%end
    else if (leaf && intersect_next(ray, walk, ${leaf-node}))
      return true;
  }
  return false;
}
