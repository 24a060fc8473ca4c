// The colour of a voxel below a node: down the first children that are not empty. 0 if the device cut the search short.
uint sample_level_N_node(uint node, bool leaf) {
  while (!leaf)
    node = KIND_first_child(node, leaf);
  return leaf ? sample_NEXT(load_word(node)) : 0u;
}

uint sample_level_N(uint root) { return sample_level_N_node(root, false); }

