// A node of an octree is [first child, masks]; its children that are not empty stand together, two words each.
// Gives child x + 2y + 4z of a node, or 0 if it is empty.
uint svo_child(uint node, int child, out bool leaf) {
  uint masks = load_word(node + 1u);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return load_word(node) + 2u * uint(bitCount(masks & ((1u << child) - 1u)));
}
