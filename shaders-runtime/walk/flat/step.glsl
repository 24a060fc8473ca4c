%if distances
    if (is_empty && layer == ${BEGIN})
%if octants
      step_over(ray, walk, Gap(LEVEL_${N}_LOG2_CELL, int(reach)));
%else
      march_level_${N}(ray, walk, reach);
%end
    is_empty = is_empty && layer != ${BEGIN};
%end
