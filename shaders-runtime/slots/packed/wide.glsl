// A node is [mask of children, mask of leaves, slots of its children...], masks of 64 bits. Slots are of those that are not empty
// or, where all leaves have one value, that are neither empty nor leaves.
// Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side. `around` is 1 if
// so are the seven that make a cube with it.
uint child_level(uint node, ivec3 cell, int height, out bool leaf, inout int around) {
  int child = child_index_of_64(cell >> height);
  uint half_mask = load_word_at(node, uint(child >> 5));
  uint bit = 1u << (child & 31);
  around = (half_mask >> (child & 24) & 255u) == 0u ? 1 : 0;
  leaf = (load_word_at(node, 2u + uint(child >> 5)) & bit) != 0u;
  if ((half_mask & bit) == 0u)
    return 0u;
  if (LEVEL_ALIKE && leaf)
    return node; // All leaves are alike, or nothing more is asked of one.
  if (LEVEL_IMPLIED)
    half_mask &= ~load_word_at(node, 2u + uint(child >> 5));
  int rank = bitCount(half_mask & (bit - 1u));
  if (child >= 32)
    rank += bitCount(LEVEL_IMPLIED ? load_word(node) & ~load_word_at(node, 2u) : load_word(node));
  return load_word_at(node, 4u + LEVEL_SLOT_WORDS * uint(rank));
}

// The same, and adds to `rank` how many voxels of the node come before those of the child or, of a leaf, before the one in the
// cell. The second word of a slot says how many the slots up to it have.
uint ranked_child_level(uint node, ivec3 cell, int height, inout uint rank, out bool leaf) {
  int child = child_index_of_64(cell >> height);
  uint half_mask = load_word_at(node, uint(child >> 5));
  uint half_leaves = load_word_at(node, 2u + uint(child >> 5));
  uint bit = 1u << (child & 31);
  uint lower = bit - 1u;
  leaf = (half_leaves & bit) != 0u;
  if ((half_mask & bit) == 0u)
    return 0u;
  int leaves = bitCount(half_leaves & lower);
  int children = bitCount(half_mask & lower);
  if (child >= 32) {
    leaves += bitCount(load_word_at(node, 2u));
    children += bitCount(load_word(node));
  }
  return ranked_slot_level(node, cell, height, children, leaves, leaf, rank);
}

// The first child of a node that is not empty.
uint first_child_level(uint node, out bool leaf) {
  uint mask = load_word(node);
  uint leaves = mask != 0u ? load_word_at(node, 2u) : load_word_at(node, 3u);
  mask = mask != 0u ? mask : load_word_at(node, 1u);
  leaf = (leaves >> findLSB(mask) & 1u) != 0u;
  return LEVEL_IMPLIED && leaf ? node : load_word_at(node, 4u);
}
