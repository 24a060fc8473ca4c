// The node, `layers` above the cells, with these children: equal leaves become one, but for the root, which is a node.
Node join_level_${N}_nodes(Build &build, const Node (&children)[LEVEL_${N}_CHILDREN], int layers) {
%if ranked
  if (layers < LEVEL_${N}_LAYERS && are_equal_leaves(children)) {
    Node leaf = children[0];
    leaf.voxels *= LEVEL_${N}_CHILDREN;
    return leaf;
  }
%else
  if (layers < LEVEL_${N}_LAYERS && are_equal_leaves(children))
    return children[0];
%end
  return write_level_${N}_node(build, children);
}
