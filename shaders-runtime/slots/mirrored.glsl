// A node is [masks, references to the children that are neither empty nor leaves...]. The highest three bits of a reference say
// across which axes the node there is reflected, x lowest; on the way down, reflections add up.
// Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint child_level(uint node, ivec3 cell, int height, out bool leaf) {
  uint begin = node & 0x1fffffffu;
  int child = child_index(cell >> height) ^ int(node >> 29);
  uint masks = load_word(begin);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  if (leaf)
    return node; // All leaves have the same value.
  masks &= ~(masks >> 8);
  uint slot = uint(bitCount(masks & ((1u << child) - 1u)));
  return load_word(begin + 1u + slot) ^ (node & 0xe0000000u);
}

// A child of a node that is not empty.
uint first_child_level(uint node, out bool leaf) {
  uint begin = node & 0x1fffffffu;
  uint masks = load_word(begin);
  leaf = (masks >> (8 + findLSB(masks & 255u)) & 1u) != 0u;
  return leaf ? node : load_word(begin + 1u) ^ (node & 0xe0000000u);
}
