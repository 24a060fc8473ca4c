// The node over the 8^height voxels at `voxels`, which lie in Morton order within a brick.
Node construct_level_N_brick(Build &build, const uint32_t *voxels, int height) {
  if (height == 0)
    return Node::leaf(*voxels);
  if (!holds_any(voxels, 1 << 3 * height))
    return {};
  Node children[8];
  for (int i = 0; i < 8; ++i)
    children[i] = construct_level_N_brick(build, voxels + (i << 3 * (height - 1)), height - 1);
  return join_level_N_nodes(build, children, height);
}

// The node over the 2^height voxels a side at `low`.
Node construct_level_N_node(Build &build, Voxel low, int height) {
  if (build.is_empty(low, height))
    return {};
  if (build.is_part(height))
    return build.take_part(low).node;
  if (height <= kLog2Brick)
    return construct_level_N_brick(build, build.voxels(low), height);
  Node children[8];
  for (int i = 0; i < 8; ++i)
    children[i] = construct_level_N_node(build, child_low(low, i, height - 1), height - 1);
  return join_level_N_nodes(build, children, height);
}
