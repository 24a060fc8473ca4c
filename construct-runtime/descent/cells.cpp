// The node over the 2^height cells a side at `low`.
Node construct_level_N_node(Build &build, Voxel low, int height) {
  const int log2_side = height + LEVEL_N_LOG2_CELL;
  if (build.is_empty(low, log2_side))
    return {};
  if (height == 0)
    return Node::leaf(construct_NEXT(build, low));
  if (build.is_part(log2_side))
    return build.take_part(low).node;
  Node children[8];
  for (int i = 0; i < 8; ++i)
    children[i] = construct_level_N_node(build, child_low(low, i, log2_side - 1), height - 1);
  return join_level_N_nodes(build, children, height);
}
