// Writes the children that are not empty as one block; the node itself joins the block of its parent.
Node write_level_${N}_node(Build &build, const Children<LEVEL_${N}_CHILDREN> &children) {
  constexpr int kMasks = mask_words(LEVEL_${N}_CHILDREN);
  if (children.filled == 0)
    return {};
  Node node = children.parent();
  uint32_t block[(1 + kMasks) * LEVEL_${N}_CHILDREN];
  uint64_t count = 0;
  for (uint64_t filled = children.filled; filled != 0;) {
    const unsigned i = take_bit(filled);
    block[count++] = children.values[i];
    for (int word = 0; word < kMasks; ++word)
      block[count++] = children.is_leaf(i) ? 0 : children.masks[i][word];
  }
  node.value = build.append(${N}, block, count);
  return node;
}
