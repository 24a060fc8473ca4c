      ${WHERE}{
%if single
        node = ${leaf-node};
        gap.log2_side = LEVEL_${N}_LOG2_CELL;
%else
%if grid
        gap = Gap(LEVEL_${N}_LOG2_CELL, 1);
        node = cell_level_${N}(${cell-ray,}node, walk.cell >> LEVEL_${N}_LOG2_CELL${cell,gap});
%else
        bool leaf = false;
        int below = ${LAST} - layer;
%if wide
        int around = 0;
%end
        node = child_level_${N}(node, walk.cell >> LEVEL_${N}_LOG2_CELL, below${times-branch}, leaf${around});
        gap = Gap(LEVEL_${N}_LOG2_CELL + below${times-branch}${plus-around}, 1);
%if last
%else
        lowest_${N} = layer;
%end
%end
%end
%if tree
        if (node != 0u && !leaf) {
          layer++;
        } else if (node != 0u) {
%if last
          value = ${leaf-node};
          node = 0u;
%else
          node = ${leaf-node};
          layer = ${END};
%end
        }
%else
%if last
        value = node;
        node = 0u;
%else
        layer += node != 0u ? 1 : 0;
%end
%end
