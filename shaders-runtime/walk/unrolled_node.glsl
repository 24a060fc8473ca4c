// Goes along the ray through a node of layer ${H}, counted from the cells, child after child, to the first leaf; 0 if there is
// none.
%if stops
// `leaf` is false where what was found is a node that looks small.
uint seek_level_layer_${H}(const Ray ray, inout Walk walk, uint node, out bool leaf) {
%else
uint seek_level_layer_${H}(const Ray ray, inout Walk walk, uint node) {
%end
  const int height = LEVEL_LOG2_CELL + ${H-1}${times-branch};
  ivec3 begin = walk.cell;
  uint found = 0u;
%if stops
  leaf = false;
  bool small = false;
  while (found == 0u && !small && is_same_cube(begin, walk.cell, height + LEVEL_BRANCH)) {
%else
  bool leaf = false;
  while (found == 0u && is_same_cube(begin, walk.cell, height + LEVEL_BRANCH)) {
%end
%if wide
    int around = 0;
%end
    uint child = child_level(node, walk.cell, height, leaf${around});
%if inner
    bool last = child == 0u || leaf;
%else
    bool last = true;
%end
%if stops
    int looks = small_height(ray, walk);
    last = last || looks >= height;
%end
    if (last)
      count_lookup(walk);
    if (child == 0u)
      step_over(ray, walk, height${plus-around});
%if inner
    else if (!last)
%if stops
      found = seek_level_layer_${H-1}(ray, walk, child, leaf);
%else
      found = seek_level_layer_${H-1}(ray, walk, child);
%end
%end
    else
      found = child;
%if stops
    // What did not look small when this node was entered may do so now: its parent stops at it.
    small = found == 0u && ${H} < LEVEL_DEPTH && small_height(ray, walk) >= height + LEVEL_BRANCH;
%end
  }
  return found;
}

