// One loop. Each turn looks at the walk's cell from the root on, through all levels.
bool intersect_level_1(const Ray ray, inout Walk walk, uint root) {
  ivec3 before = walk.cell;
  while (goes_on(walk)) {
    count_lookup(walk);
    Gap gap = Gap(0, 1);
    real3 face = real3(0);
    uint value = locate_level_1(ray, root, walk.cell, gap, face);
    if (PAGED && lacks_page)
      return false;
    if (COLOUR && value != 0u) {
      walk.voxel = value;
      return true;
    }
    if (!COLOUR && value != 0u)
      return true;
    if (KEEPS_CELL)
      before = walk.cell;
    if (LOOK_UPS_MAY_BE_CUT && gap.count == 0)
      continue; // The device ended a look-up.
    if (TELLS_FACES)
      step_over(ray, walk, gap, face);
    else
      step_over(ray, walk, gap);
  }
  if (KEEPS_CELL)
    put_outside(walk, before);
  return false;
}
