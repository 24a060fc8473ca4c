bool intersect_level(const Ray ray, inout Walk walk, uint root) {
%if first
  while (goes_on(walk)) {
%else
  ivec3 begin = walk.cell;
  while (within_level(begin, walk.cell)) {
%end
%if stops
    bool leaf;
    uint found = seek_level_layer_${DEPTH}(ray, walk, root, leaf);
    if (found != 0u && (!leaf || small_height(ray, walk) >= LEVEL_LOG2_CELL))
%if colour
      return stop_with(walk, sample_level_node(found, leaf));
%else
      return true;
%end
    if (found != 0u && intersect_next(ray, walk, ${leaf-found}))
      return true;
%else
    uint leaf = seek_level_layer_${DEPTH}(ray, walk, root);
    if (leaf != 0u && intersect_next(ray, walk, ${leaf-leaf}))
      return true;
%end
  }
  return false;
}
