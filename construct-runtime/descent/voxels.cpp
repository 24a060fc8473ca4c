// The node, `layers` above the voxels of a brick from `first` on.
Node construct_level_${N}_brick(Build &build, const Brick &brick, unsigned first, int layers) {
  if (layers == 0)
%if ranked
    return build.put_voxel(brick.voxels[first]);
%else
    return Node::leaf(brick.voxels[first]);
%end
  if (!brick.holds_any(first, 3 * LEVEL_${N}_BRANCH * layers))
    return {};
  Children<LEVEL_${N}_CHILDREN> children;
%if ranked
  for (unsigned i = 0; i < LEVEL_${N}_CHILDREN; ++i)
    children.put(i, construct_level_${N}_brick(build, brick, first + (i << 3 * LEVEL_${N}_BRANCH * (layers - 1)), layers - 1));
%else
  if (layers == 1)
    children.put_voxels(brick, first);
  else
    for (unsigned i = 0; i < LEVEL_${N}_CHILDREN; ++i)
      children.put(i, construct_level_${N}_brick(build, brick, first + (i << 3 * LEVEL_${N}_BRANCH * (layers - 1)), layers - 1));
%end
  return join_level_${N}_nodes(build, children, layers);
}

// The node, `layers` above the voxels, whose low corner is `low`.
Node construct_level_${N}_node(Build &build, Voxel low, int layers) {
  const int log2_side = layers * LEVEL_${N}_BRANCH;
  if (build.is_empty(low, log2_side))
    return {};
  if (build.is_part(log2_side))
    return build.take_part(low).node;
  if (log2_side <= kLog2Brick) {
    const Brick &brick = build.brick(low);
%if looks-ahead
    if (log2_side == kLog2Brick)
      look_ahead_level_${N}(build, brick);
%end
    return construct_level_${N}_brick(build, brick, brick_index(low), layers);
  }
  Children<LEVEL_${N}_CHILDREN> children;
  for (unsigned i = 0; i < LEVEL_${N}_CHILDREN; ++i)
    children.put(i, construct_level_${N}_node(build, child_low(low, i, log2_side - LEVEL_${N}_BRANCH), layers - 1));
  return join_level_${N}_nodes(build, children, layers);
}
