// The colour of a voxel below a node: down the first children that are not empty. 0 if the device cut the search short.
uint sample_level_node(uint node, bool leaf) {
  while (!leaf)
    node = first_child_level(node, leaf);
  return leaf ? sample_next(leaf_level(node)) : 0u;
}

uint sample_level(uint root) { return sample_level_node(root, false); }
