%if first
%else
    if (highest < LEVEL_${N}_LOG2_SIDE)
%if tree
%else
      ancestor = ${BEGIN};
%end
%end
%if tree
%if first
    ancestor = min(${climb}, ${LOWEST});
%else
      ancestor = min(${BEGIN} + ${climb}, ${LOWEST});
%end
%end
