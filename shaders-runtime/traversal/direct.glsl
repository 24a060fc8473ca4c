// One loop. Each turn looks at the traversal's cell from the root on, through all levels.
bool intersect_level_1(const Ray ray, inout Traversal traversal, uint root) {
  ivec3 before = traversal.cell;
  while (goes_on(traversal)) {
    count_lookup(traversal);
    EmptySpan span = EmptySpan(0, 1);
    real3 face = real3(0);
    uint value = locate_level_1(ray, root, traversal.cell, span, face);
    if (PAGED && lacks_page)
      return false;
    if (COLOUR && value != 0u) {
      traversal.voxel = value;
      return true;
    }
    if (!COLOUR && value != 0u)
      return true;
    if (KEEPS_CELL)
      before = traversal.cell;
    if (LOOK_UPS_MAY_BE_CUT && span.count == 0)
      continue; // The device ended a look-up.
    if (REPORTS_FACES)
      step_over(ray, traversal, span, face);
    else
      step_over(ray, traversal, span);
  }
  if (KEEPS_CELL)
    put_outside(traversal, before);
  return false;
}
