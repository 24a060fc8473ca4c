// The node of 2^height cells a side with these children: equal leaves become one, but for the root, which is a node.
Node join_level_N_nodes(Build &build, const Node (&children)[8], int height) {
  if (height < LEVEL_N_DEPTH && are_equal_leaves(children))
    return children[0];
  return write_level_N_node(build, children);
}
