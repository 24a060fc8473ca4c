%if wide
// A node is [mask of children, mask of leaves, ${slots-hold} the children that ${have-slots}...], masks of 64 bits.
// Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side. `around` is 1 if
// so are the seven that make a cube with it.
uint child_level(uint node, ivec3 cell, int height, out bool leaf, out int around) {
  int child = child_index_of_64(cell >> height);
  uint half_mask = load_word_at(node, uint(child >> 5));
  uint bit = 1u << (child & 31);
  around = (half_mask >> (child & 24) & 255u) == 0u ? 1 : 0;
  leaf = (load_word_at(node, 2u + uint(child >> 5)) & bit) != 0u;
  if ((half_mask & bit) == 0u)
    return 0u;
%if alike
  if (leaf)
    return node; // ${why-alike}
%end
%if implied
  half_mask &= ~load_word_at(node, 2u + uint(child >> 5));
%end
  int rank = bitCount(half_mask & (bit - 1u));
  if (child >= 32)
    rank += bitCount(load_word(node)${without-leaves});
  return load_word_at(node, 4u + ${slots-times}uint(rank));
}
%else
// A node is [masks, ${slots-hold} the children that ${have-slots}...].
// Gives the child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint child_level(uint node, ivec3 cell, int height, out bool leaf) {
  int child = child_index(cell >> height);
  uint masks = load_word(node);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
%if alike
  if (leaf)
    return node; // ${why-alike}
%end
%if implied
  masks &= ~(masks >> 8);
%end
  return load_word_at(node, 1u + ${slots-times}uint(bitCount(masks & ((1u << child) - 1u))));
}
%end

// The same, and adds to `rank` how many voxels of the node come before those of the child or, of a leaf, before the one in the
// cell. The second word of a slot says how many the slots up to it have.
uint ranked_child_level(uint node, ivec3 cell, int height, inout uint rank, out bool leaf) {
%if wide
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
%else
  int child = child_index(cell >> height);
  uint masks = load_word(node);
  uint lower = (1u << child) - 1u;
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  int leaves = bitCount(masks >> 8 & lower);
  int children = bitCount(masks & lower);
%end
%if implied
  rank += uint(leaves) << (3 * height);
  int slots = children - leaves;
%else
  int slots = children;
%end
  uint slot = ${node+}${head-words}u + 2u * uint(slots);
  uint before = slots > 0 ? load_word(${node,}slot - 1u) : 0u;
  rank += before;
%if implied
  if (leaf) {
    rank += place_in_cube(cell, height);
    return node;
  }
%else
  if (leaf)
    rank += place_in_cube(cell, height) * (load_word(${node,}slot + 1u) - before >> (3 * height));
%end
  return load_word(${node,}slot);
}

// The first child of a node that is not empty.
uint first_child_level(uint node, out bool leaf) {
%if wide
  uint mask = load_word(node);
  uint leaves = mask != 0u ? load_word_at(node, 2u) : load_word_at(node, 3u);
  mask = mask != 0u ? mask : load_word_at(node, 1u);
  leaf = (leaves >> findLSB(mask) & 1u) != 0u;
  return ${first-slot}node${+}4u);
%else
  uint masks = load_word(node);
  leaf = (masks >> (8 + findLSB(masks & 255u)) & 1u) != 0u;
  return ${first-slot}node${+}1u);
%end
}
