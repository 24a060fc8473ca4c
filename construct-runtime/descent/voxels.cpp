// The node, `layers` above the voxels at `voxels`, which lie in Morton order within a brick.
Node construct_level_${N}_brick(Build &build, const uint32_t *voxels, int layers) {
  if (layers == 0)
%if ranked
    return build.put_voxel(*voxels);
%else
    return Node::leaf(*voxels);
%end
  if (!holds_any(voxels, 1 << 3 * LEVEL_${N}_BRANCH * layers))
    return {};
  Node children[LEVEL_${N}_CHILDREN];
  for (int i = 0; i < LEVEL_${N}_CHILDREN; ++i)
    children[i] = construct_level_${N}_brick(build, voxels + (i << 3 * LEVEL_${N}_BRANCH * (layers - 1)), layers - 1);
  return join_level_${N}_nodes(build, children, layers);
}

// The node, `layers` above the voxels, whose low corner is `low`.
Node construct_level_${N}_node(Build &build, Voxel low, int layers) {
  const int log2_side = layers * LEVEL_${N}_BRANCH;
  if (build.is_empty(low, log2_side))
    return {};
  if (build.is_part(log2_side))
    return build.take_part(low).node;
  if (log2_side <= kLog2Brick)
    return construct_level_${N}_brick(build, build.voxels(low), layers);
  Node children[LEVEL_${N}_CHILDREN];
  for (unsigned i = 0; i < LEVEL_${N}_CHILDREN; ++i)
    children[i] = construct_level_${N}_node(build, child_low(low, i, log2_side - LEVEL_${N}_BRANCH), layers - 1);
  return join_level_${N}_nodes(build, children, layers);
}
