// A node is [masks, slots of its children...]: a bit for each child that is not empty, one for each that is a leaf, and slots of
// those that are not empty or, where all leaves have one value, that are neither empty nor leaves.
// Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint child_level(uint node, ivec3 cell, int height, out bool leaf) {
  int child = child_index(cell >> height);
  uint masks = load_word(node);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  if (LEVEL_ALIKE && leaf)
    return node; // All leaves are alike, or nothing more is asked of one.
  if (LEVEL_IMPLIED)
    masks &= ~(masks >> 8);
  return load_word_at(node, 1u + LEVEL_SLOT_WORDS * uint(bitCount(masks & ((1u << child) - 1u))));
}

// The same, and adds to `rank` how many voxels of the node come before those of the child or, of a leaf, before the one in the
// cell. The second word of a slot says how many the slots up to it have.
uint ranked_child_level(uint node, ivec3 cell, int height, inout uint rank, out bool leaf) {
  int child = child_index(cell >> height);
  uint masks = load_word(node);
  uint lower = (1u << child) - 1u;
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  int leaves = bitCount(masks >> 8 & lower);
  int children = bitCount(masks & lower);
  return ranked_slot_level(node, cell, height, children, leaves, leaf, rank);
}

// The first child of a node that is not empty.
uint first_child_level(uint node, out bool leaf) {
  uint masks = load_word(node);
  leaf = (masks >> (8 + findLSB(masks & 255u)) & 1u) != 0u;
  return LEVEL_IMPLIED && leaf ? node : load_word_at(node, 1u);
}
