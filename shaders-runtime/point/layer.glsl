  if (node != 0u && !leaf)
    node = child_level_${N}(node, at, ${H-1}${times-branch}, leaf${around});
