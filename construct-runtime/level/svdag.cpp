Node construct_level_N_node(Build &build, Voxel low, int height);

// Writes a node, and before it those of its children that are leaves, each unless it is written already.
Node write_level_N_node(Build &build, const Node (&children)[8]) {
  uint32_t words[9];
  uint64_t count = 1;
  for (const Node &child : children)
    if (child.kind != Node::Empty)
      words[count++] = child.kind == Node::Leaf ? build.intern_leaf(N, child.value) : child.value;
  words[0] = masks_of(children);
  return count == 1 ? Node{} : Node{Node::Inner, build.intern(N, words, count), words[0]};
}

uint32_t construct_level_N(Build &build, Voxel low) {
  if (!LEVEL_N_SHARES_ACROSS_SUB_VOLUMES)
    build.forget(N);
  const Node root = construct_level_N_node(build, low, LEVEL_N_DEPTH);
  return root.kind == Node::Leaf ? build.intern_leaf(N, root.value) : root.value;
}
