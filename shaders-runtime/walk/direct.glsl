// One loop. Each turn looks at the walk's cell from the root on, through all levels.
bool intersect_level_1(const Ray ray, inout Walk walk, uint root) {
  while (goes_on(walk)) {
    count_lookup(walk);
    Gap gap = Gap(0, 1);
    uint value = locate_level_1(ray, root, walk.cell, gap);
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
%if any-look-up-may-be-cut
    if (gap.count > 0) // Else the device ended a look-up.
      step_over(ray, walk, gap);
%else
    step_over(ray, walk, gap);
%end
  }
  return false;
}
