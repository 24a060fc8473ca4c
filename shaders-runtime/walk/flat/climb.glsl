%if first
%else
    if (highest < LEVEL_${N}_LOG2_SIDE)
%if tree
%else
      common = ${BEGIN};
%end
%end
%if tree
%if first
    common = min((LEVEL_${N}_LOG2_SIDE - 1 - highest)${per-branch}, ${LOWEST});
%else
      common = ${BEGIN} + min((LEVEL_${N}_LOG2_SIDE - 1 - highest)${per-branch}, ${LOWEST} - ${BEGIN});
%end
%end
