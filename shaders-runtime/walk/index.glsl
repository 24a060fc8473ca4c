bool intersect_level_${N}(const Ray ray, inout Walk walk, uint grid) {
%if first
  while (goes_on(walk)) {
%else
  ivec3 begin = walk.cell;
  while (within_level_${N}(begin, walk.cell)) {
%end
    count_lookup(walk);
%if octants
    uint reach;
    uint value = cell_level_${N}(grid, walk.cell >> LEVEL_${N}_LOG2_CELL, octant_of(ray), reach);
    if (value == 0u)
      step_over(ray, walk, Gap(LEVEL_${N}_LOG2_CELL, int(reach)));
%else
%if distances
    uint reach;
    uint value = cell_level_${N}(grid, walk.cell >> LEVEL_${N}_LOG2_CELL, reach);
    if (value == 0u)
      march_level_${N}(ray, walk, reach);
%else
%if tells-around
    int around;
    uint value = cell_level_${N}(ray, grid, walk.cell >> LEVEL_${N}_LOG2_CELL, around);
%else
    uint value = cell_level_${N}(grid, walk.cell >> LEVEL_${N}_LOG2_CELL);
%end
    if (value == 0u)
      step_over(ray, walk, LEVEL_${N}_LOG2_CELL${plus-around});
%end
%end
%if stops
    else if (small_height(ray, walk) >= LEVEL_${N}_LOG2_CELL)
      return stop_with(walk, sample_${NEXT}(value));
%end
    else if (intersect_${NEXT}(ray, walk, value))
      return true;
  }
  return false;
}
