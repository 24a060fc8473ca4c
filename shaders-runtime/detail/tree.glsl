// The colour of a voxel below a node: down the first children that are not empty. 0 if the device cut the search short.
uint sample_level_${N}_node(uint node, bool leaf) {
  while (!leaf)
    node = first_child_level_${N}(node, leaf);
  return leaf ? sample_${NEXT}(${leaf-node}) : 0u;
}

uint sample_level_${N}(uint root) { return sample_level_${N}_node(root, false); }

