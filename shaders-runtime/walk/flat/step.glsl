%if marches
    if (is_empty && layer == ${BEGIN})
      march_level_${N}(ray, walk, gap.count);
    is_empty = is_empty && layer != ${BEGIN};
%end
