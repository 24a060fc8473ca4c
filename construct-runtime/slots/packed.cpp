%if ranked
// Behind each slot stands how many voxels the slots up to this one have.
%end
%if leaves-apart
// Fills in the words of a node with these children and returns how many. `leaf_of` tells where the word of a leaf is; where it
// tells 0, of a leaf that is not written yet, there are no words.
template <typename LeafOf>
uint64_t fill_level_${N}_node(const Children<LEVEL_${N}_CHILDREN> &children, uint32_t *words, const LeafOf &leaf_of) {
%else
// Fills in the words of a node with these children and returns how many.
uint64_t fill_level_${N}_node(const Children<LEVEL_${N}_CHILDREN> &children, uint32_t *words) {
%end
  const Node node = children.parent();
  uint64_t count = 0;
  for (; count < mask_words(LEVEL_${N}_CHILDREN); ++count)
    words[count] = node.masks[count];
%if ranked
  uint32_t voxels = 0;
%end
  for (uint64_t slots = ${slots-of-children}; slots != 0;) {
    const unsigned i = take_bit(slots);
%if leaves-apart
    words[count] = children.is_leaf(i) ? leaf_of(children.values[i]) : children.values[i];
    if (words[count++] == 0)
      return 0;
%else
    words[count++] = children.values[i];
%end
%if ranked
    voxels += children.voxels[i];
    words[count++] = voxels;
%end
  }
  return count;
}

%if implied
// Writes a node, unless it is written already. Its masks say which children are leaves, and that is all there is to say of them.
%else
%if leaves-in-slots
// Writes a node, unless it is written already, with the values of the children that are leaves.
%else
// Writes a node, and before it those of its children that are leaves, each unless it is written already.
%end
%end
Node write_level_${N}_node(Build &build, const Children<LEVEL_${N}_CHILDREN> &children) {
  if (children.filled == 0)
    return {};
  uint32_t words[mask_words(LEVEL_${N}_CHILDREN) + ${slot-words-times}LEVEL_${N}_CHILDREN];
%if leaves-apart
  const auto leaf_of = [&](uint32_t value) { return build.intern_leaf(${N}, value); };
  const uint64_t count = fill_level_${N}_node(children, words, leaf_of);
%else
  const uint64_t count = fill_level_${N}_node(children, words);
%end
  Node node = children.parent();
%if ranked
  for (uint64_t filled = children.filled; filled != 0;)
    node.voxels += children.voxels[take_bit(filled)];
%end
  node.value = build.intern(${N}, words, count);
  return node;
}
%if looks-ahead

// Tells of the nodes above the voxels of a brick before they are written, so that what they are compared with is near then. Nodes
// with a leaf that is not written yet are left out.
void look_ahead_level_${N}(Build &build, const Brick &brick) {
  uint32_t words[mask_words(LEVEL_${N}_CHILDREN) + ${slot-words-times}LEVEL_${N}_CHILDREN];
  for (unsigned first = 0; first < 512; first += LEVEL_${N}_CHILDREN) {
    if (brick.filled_from(first, LEVEL_${N}_CHILDREN) == 0)
      continue;
    Children<LEVEL_${N}_CHILDREN> children;
    children.put_voxels(brick, first);
%if leaves-apart
    const auto leaf_of = [&](uint32_t value) { return build.find_leaf(${N}, value); };
    if (const uint64_t count = fill_level_${N}_node(children, words, leaf_of))
      build.announce(${N}, words, count);
%else
    build.announce(${N}, words, fill_level_${N}_node(children, words));
%end
  }
  build.end_announcing(${N});
}
%end
