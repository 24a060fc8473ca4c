  if (node != 0u && !leaf)
    node = ranked_child_level(node, at, ${H-1}${times-branch}, rank, leaf);
