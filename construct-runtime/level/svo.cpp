Node construct_level_N_node(Build &build, Voxel low, int height);

// Writes the children that are not empty as one block; the node itself joins the block of its parent.
Node write_level_N_node(Build &build, const Node (&children)[8]) {
  uint32_t block[16];
  uint64_t words = 0;
  for (const Node &child : children) {
    if (child.kind == Node::Empty)
      continue;
    block[words++] = child.value;
    block[words++] = child.masks;
  }
  return words == 0 ? Node{} : Node{Node::Inner, build.append(N, block, words), masks_of(children)};
}

uint32_t construct_level_N(Build &build, Voxel low) {
  const Node root = construct_level_N_node(build, low, LEVEL_N_DEPTH);
  const uint32_t words[2] = {root.value, root.masks};
  return root.kind == Node::Empty ? 0 : build.append(N, words, 2);
}
