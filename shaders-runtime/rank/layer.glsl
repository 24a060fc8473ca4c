  if (node != 0u && !leaf)
    node = ranked_child_level_${N}(node, at, ${H-1}${times-branch}, rank, leaf);
