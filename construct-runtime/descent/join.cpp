// The node, `layers` above the cells, with these children: equal leaves become one, but for the root, which is a node.
Node join_level_${N}_nodes(Build &build, const Children<LEVEL_${N}_CHILDREN> &children, int layers) {
%if ranked
  if (layers < LEVEL_${N}_LAYERS && children.are_equal_leaves()) {
    Node leaf = Node::leaf(children.values[0]);
    leaf.voxels = children.voxels[0] * LEVEL_${N}_CHILDREN;
    return leaf;
  }
%else
  if (layers < LEVEL_${N}_LAYERS && children.are_equal_leaves())
    return Node::leaf(children.values[0]);
%end
  return write_level_${N}_node(build, children);
}
