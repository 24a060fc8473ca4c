// One loop. Each turn looks at the walk's cell from the root on, through all levels.
bool intersect_level_1(const Ray ray, inout Walk walk, uint root) {
%if keeps-cell
  ivec3 before = walk.cell;
%end
  while (goes_on(walk)) {
    count_lookup(walk);
    Gap gap = Gap(0, 1);
%if tells-faces
    real3 face = real3(0);
%end
    uint value = locate_level_1(ray, root, walk.cell, gap${and-face});
%if paged
    if (lacks_page)
      return false;
%end
%if colour
    if (value != 0u) {
      walk.voxel = value;
      return true;
    }
%else
    if (value != 0u)
      return true;
%end
%if keeps-cell
    before = walk.cell;
%end
%if any-look-up-may-be-cut
    if (gap.count > 0) // Else the device ended a look-up.
      step_over(ray, walk, gap${and-face});
%else
    step_over(ray, walk, gap${and-face});
%end
  }
%if keeps-cell
  put_outside(walk, before);
%end
  return false;
}
