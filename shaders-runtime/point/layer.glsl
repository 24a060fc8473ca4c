  if (node != 0u && !leaf)
    node = child_level(node, at, ${H-1}${times-branch}, leaf${around});
