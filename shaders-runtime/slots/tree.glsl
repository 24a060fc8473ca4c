// The value of a leaf that was found: of its own word, of its slot, or the one that all have.
INLINE uint leaf_level(uint leaf) {
  return LEVEL_DEFERS ? leaf : LEVEL_IMPLIED ? OCCUPIED : LEVEL_LEAVES_IN_SLOTS ? leaf : load_word(leaf);
}

// The child around a cell; where nodes have 64 children, `around` is 1 if the seven that make a cube with it are empty as well.
INLINE uint descend_level(uint node, ivec3 cell, int height, out bool leaf, inout int around) {
  return LEVEL_WIDE ? child_level(node, cell, height, leaf, around) : child_level(node, cell, height, leaf);
}
