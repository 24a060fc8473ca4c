%if implied
// Writes a node, unless it is written already. Its masks say which children are leaves, and that is all there is to say of them.
%else
%if leaves-in-slots
// Writes a node, unless it is written already, with the values of the children that are leaves.
%else
// Writes a node, and before it those of its children that are leaves, each unless it is written already.
%end
%end
%if ranked
// Behind each slot stands how many voxels the slots up to this one have.
%end
Node write_level_${N}_node(Build &build, const Node (&children)[LEVEL_${N}_CHILDREN]) {
  constexpr int kMasks = mask_words(LEVEL_${N}_CHILDREN);
  Node node = {Node::Inner};
  if (set_masks(children, node.masks) == 0)
    return {};
  uint32_t words[kMasks + ${slot-words-times}LEVEL_${N}_CHILDREN];
  uint64_t count = 0;
  for (; count < kMasks; ++count)
    words[count] = node.masks[count];
%if ranked
  uint32_t voxels = 0;
%end
  for (const Node &child : children) {
%if ranked
    node.voxels += child.voxels;
%end
    if (child.kind ${has-no-slot})
      continue;
%if leaves-apart
    words[count++] = child.kind == Node::Leaf ? build.intern_leaf(${N}, child.value) : child.value;
%else
    words[count++] = child.value;
%end
%if ranked
    voxels += child.voxels;
    words[count++] = voxels;
%end
  }
  node.value = build.intern(${N}, words, count);
  return node;
}
