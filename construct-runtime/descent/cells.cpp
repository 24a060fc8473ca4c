// The node, `layers` above the cells, whose low corner is `low`.
Node construct_level_${N}_node(Build &build, Voxel low, int layers) {
  const int log2_side = LEVEL_${N}_LOG2_CELL + layers * LEVEL_${N}_BRANCH;
  if (build.is_empty(low, log2_side))
    return {};
%if ranked
  if (layers == 0) {
    const uint32_t before = build.values();
    Node cell = Node::leaf(construct_${NEXT}(build, low));
    cell.voxels = build.values() - before;
    return cell;
  }
%else
  if (layers == 0)
    return Node::leaf(construct_${NEXT}(build, low));
%end
  if (build.is_part(log2_side))
    return build.take_part(low).node;
  Children<LEVEL_${N}_CHILDREN> children;
  for (unsigned i = 0; i < LEVEL_${N}_CHILDREN; ++i)
    children.put(i, construct_level_${N}_node(build, child_low(low, i, log2_side - LEVEL_${N}_BRANCH), layers - 1));
  return join_level_${N}_nodes(build, children, layers);
}
