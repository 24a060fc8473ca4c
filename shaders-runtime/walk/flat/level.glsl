      ${WHERE}{
%if single
        node = ${leaf-node};
        side = LEVEL_${N}_LOG2_CELL;
%else
%if grid
%if distances
        node = cell_level_${N}(node, walk.cell >> LEVEL_${N}_LOG2_CELL${octant}, reach);
%else
%if tells-around
        int around = 0;
        node = cell_level_${N}(ray, node, walk.cell >> LEVEL_${N}_LOG2_CELL, around);
%else
%if probes
        node = cell_level_${N}(node, walk.cell >> LEVEL_${N}_LOG2_CELL, known);
%else
        node = cell_level_${N}(node, walk.cell >> LEVEL_${N}_LOG2_CELL);
%end
%end
%end
        side = LEVEL_${N}_LOG2_CELL${grid-plus-around};
%else
        bool leaf = false;
        int below = ${LAST} - layer;
%if wide
        int around = 0;
%end
        node = child_level_${N}(node, walk.cell >> LEVEL_${N}_LOG2_CELL, below${times-branch}, leaf${around});
        side = LEVEL_${N}_LOG2_CELL + below${times-branch}${plus-around};
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
          node = load_word(node);
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
