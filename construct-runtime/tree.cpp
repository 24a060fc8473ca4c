// The node over the 2^height cells a side at `low`.
Node construct_level_N_node(Build &build, Voxel low, int height) {
  if (build.is_empty(low, height + LEVEL_N_LOG2_CELL))
    return {};
  if (height == 0)
    return Node::leaf(construct_NEXT(build, low));
  Node children[8];
  for (int i = 0; i < 8; ++i)
    children[i] = construct_level_N_node(build, child_low(low, i, height - 1 + LEVEL_N_LOG2_CELL), height - 1);
  if (height < LEVEL_N_DEPTH && are_equal_leaves(children))
    return children[0];
  return write_level_N_node(build, children);
}
