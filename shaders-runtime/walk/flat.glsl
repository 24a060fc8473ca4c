// All levels in one loop. path[i] is the node in layer i around the walk's cell, counted from the root through all levels; a
// step climbs only to the lowest node that has the old cell and the new.
%if stack-shared
shared uint path[${LAYERS}][gl_WorkGroupSize.x];

%end
bool intersect_level_1(const Ray ray, inout Walk walk, uint root) {
%if stack-shared
%else
  uint path[${LAYERS}];
%end
  path[0]${of-ray} = root;
  int layer = 0;
${FLAT_BEGIN}  while (goes_on(walk)) {
    // Down to a voxel, or to the gap around the cell.
    count_lookup(walk);
    uint node = path[layer]${of-ray};
    uint value = 0u;
    Gap gap = Gap(0, 1);
    while (node != 0u) {
      path[layer]${of-ray} = node;
${FLAT_LEVELS}      }
    }
%if colour
    if (value != 0u) {
      walk.voxel = value;
      return true;
    }
%else
    if (value != 0u)
      return true;
%end
    ivec3 before = walk.cell;
%if any-look-up-may-be-cut
    bool is_empty = node == 0u && gap.count > 0; // Else the device ended the loop above, or one in it.
%else
    bool is_empty = node == 0u; // Else the device ended the loop above.
%end
${FLAT_STEP}    if (is_empty)
      step_over(ray, walk, gap);
    ivec3 changed = before ^ walk.cell;
    int highest = findMSB(uint(changed.x | changed.y | changed.z));
    int ancestor = 0;
${FLAT_CLIMB}    layer = min(layer, ancestor);
  }
  return false;
}
