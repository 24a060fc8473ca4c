// The first child of a node that is not empty.
uint svo_first_child(uint node, out bool leaf) {
  uint masks = load_word(node + 1u);
  leaf = (masks >> (8 + findLSB(masks & 255u)) & 1u) != 0u;
  return load_word(node);
}
