// The node, `layers` above the cells, whose low corner is `low`, when its children are edited. `old` is what it was.
Node change_level_${N}_node(Edit &edit, const Node &old, Voxel low, int layers);

// The same of any node. That of the sub-volume as a whole is edited already.
Node edit_level_${N}_node(Edit &edit, const Node &old, Voxel low, int layers) {
  if (layers == 0)
    return Node::leaf(edit_${NEXT}(edit, old.value, low));
  const int log2_side = LEVEL_${N}_LOG2_CELL + layers * LEVEL_${N}_BRANCH;
  uint32_t value = 0;
  switch (edit.effect(low, log2_side, value)) {
  case Effect::Keep:
    return old;
  case Effect::Set:
    edit.replace(${N}, layers, old, log2_side, value);
    return Node::leaf(filled_${NEXT}(edit, value));
  case Effect::Change:
    break;
  }
  return change_level_${N}_node(edit, old, low, layers);
}

Node change_level_${N}_node(Edit &edit, const Node &old, Voxel low, int layers) {
  if (layers == 0) // Of a sub-volume of one cell.
    return Node::leaf(edit_${NEXT}(edit, old.value, low));
  const int log2_child = LEVEL_${N}_LOG2_CELL + (layers - 1) * LEVEL_${N}_BRANCH;
  Node before[LEVEL_${N}_CHILDREN];
  edit.children(${N}, old, before, LEVEL_${N}_CHILDREN);
  Children<LEVEL_${N}_CHILDREN> children;
  bool differs = false;
  for (unsigned i = 0; i < LEVEL_${N}_CHILDREN; ++i) {
    const Node child = edit_level_${N}_node(edit, before[i], child_low(low, i, log2_child), layers - 1);
    differs |= !are_same(child, before[i]);
    children.put(i, child);
  }
  return differs ? join_level_${N}_nodes(edit, children, layers) : old;
}

uint32_t change_level_${N}(Edit &edit, uint32_t old, Voxel low) {
  const Node root = edit.root(${N}, old);
  const Node changed = change_level_${N}_node(edit, root, low, LEVEL_${N}_LAYERS);
  return are_same(root, changed) ? old : root_level_${N}(edit, changed);
}

// A sub-volume of voxels of one value: its root is a node of leaves.
uint32_t fill_level_${N}(Edit &edit, uint32_t value) {
  const Node leaf = Node::leaf(filled_${NEXT}(edit, value));
  if (LEVEL_${N}_LAYERS == 0)
    return root_level_${N}(edit, leaf);
  Children<LEVEL_${N}_CHILDREN> children;
  for (unsigned i = 0; i < LEVEL_${N}_CHILDREN; ++i)
    children.put(i, leaf);
  return root_level_${N}(edit, join_level_${N}_nodes(edit, children, LEVEL_${N}_LAYERS));
}
