bool intersect_level(const Ray ray, inout Walk walk, uint grid) {
%if first
  while (goes_on(walk)) {
%else
  ivec3 begin = walk.cell;
  while (within_level(begin, walk.cell)) {
%end
    count_lookup(walk);
    Gap gap = Gap(LEVEL_LOG2_CELL, 1);
    uint value = cell_level(${cell-ray,}grid, walk.cell >> LEVEL_LOG2_CELL${cell,gap});
%if look-up-may-be-cut
    if (value == 0u && gap.count == 0)
      continue; // The device ended the look-up.
%end
    if (value == 0u)
%if marches
      march_level(ray, walk, gap.count);
%else
%if one-voxel-steps
      step_over_voxel(ray, walk);
%else
      step_over(ray, walk, gap);
%end
%end
%if stops
    else if (small_height(ray, walk) >= LEVEL_LOG2_CELL)
%if colour
      return stop_with(walk, sample_next(value));
%else
      return true;
%end
%end
    else if (intersect_next(ray, walk, value))
      return true;
  }
  return false;
}
