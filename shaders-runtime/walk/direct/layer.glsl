  if (node != 0u && !leaf) {
    node = child_level(node, at, ${H-1}${times-branch}, leaf${around});
    gap = Gap(LEVEL_LOG2_CELL + ${H-1}${times-branch}${plus-around}, 1);
  }
