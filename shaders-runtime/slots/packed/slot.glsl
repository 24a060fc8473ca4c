// What the slot of a child leads to that comes behind so many children of its node, of which so many are leaves. Adds to `rank`
// how many voxels these have and, of a leaf, how many of its own come before the cell.
uint ranked_slot_level(uint node, ivec3 cell, int height, int children, int leaves, bool leaf, inout uint rank) {
  if (LEVEL_IMPLIED)
    rank += uint(leaves) << (3 * height);
  int slots = LEVEL_IMPLIED ? children - leaves : children;
  uint slot = place_of_word(node, LEVEL_HEAD_WORDS + 2u * uint(slots));
  uint before = slots > 0 ? load_word_from(node, slot - 1u) : 0u;
  rank += before;
  if (LEVEL_IMPLIED && leaf)
    rank += place_in_cube(cell, height);
  if (!LEVEL_IMPLIED && leaf)
    rank += place_in_cube(cell, height) * (load_word_from(node, slot + 1u) - before >> (3 * height));
  return LEVEL_IMPLIED && leaf ? node : load_word_from(node, slot);
}
