%if distances
    if (is_empty && layer == ${BEGIN})
      march_level_${N}(ray, walk, reach);
    is_empty = is_empty && layer != ${BEGIN};
%end
