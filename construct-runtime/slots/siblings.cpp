// Writes the children that are not empty as one block; the node itself joins the block of its parent.
Node write_level_${N}_node(Build &build, const Node (&children)[LEVEL_${N}_CHILDREN]) {
  constexpr int kMasks = mask_words(LEVEL_${N}_CHILDREN);
  Node node = {Node::Inner};
  if (set_masks(children, node.masks) == 0)
    return {};
  uint32_t block[(1 + kMasks) * LEVEL_${N}_CHILDREN];
  uint64_t count = 0;
  for (const Node &child : children) {
    if (child.kind == Node::Empty)
      continue;
    block[count++] = child.value;
    for (int i = 0; i < kMasks; ++i)
      block[count++] = child.masks[i];
  }
  node.value = build.append(${N}, block, count);
  return node;
}
