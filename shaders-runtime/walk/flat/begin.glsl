%if tree
%if last
%else
  int lowest_${N} = 0; // The lowest layer of level ${N} with a node around the cell: a leaf may stand above the others.
%end
%end
