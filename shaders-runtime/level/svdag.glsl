// A node of a DAG is [masks, pointers to the children that are not empty...].
// Gives child x + 2y + 4z of a node, or 0 if it is empty.
uint svdag_child(uint node, int child, out bool leaf) {
  uint masks = load_word(node);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return load_word(node + 1u + uint(bitCount(masks & ((1u << child) - 1u))));
}
