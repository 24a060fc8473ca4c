// A node of an octree is [first child, masks]; its children that are not empty stand together, two words each.
// Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint child_level(uint node, ivec3 cell, int height, out bool leaf) {
  int child = child_index(cell >> height);
  uint masks = load_word_at(node, 1u);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  if (LEVEL_ALIKE && leaf)
    return node; // All leaves are alike, or nothing more is asked of one.
  return load_word(node) + LEVEL_RECORD_GRANULES * uint(bitCount(masks & ((1u << child) - 1u)));
}

// The first child of a node that is not empty.
uint first_child_level(uint node, out bool leaf) {
  uint masks = load_word_at(node, 1u);
  leaf = (masks >> (8 + findLSB(masks & 255u)) & 1u) != 0u;
  return load_word(node);
}
