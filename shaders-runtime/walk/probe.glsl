bool intersect_level_${N}(const Ray ray, inout Walk walk, uint table) {
%if first
  while (goes_on(walk)) {
%else
  ivec3 begin = walk.cell;
  while (within_level_${N}(begin, walk.cell)) {
%end
    count_lookup(walk);
    bool known;
    uint value = cell_level_${N}(table, walk.cell >> LEVEL_${N}_LOG2_CELL, known);
    if (known && value == 0u)
      step_over(ray, walk, LEVEL_${N}_LOG2_CELL);
%if stops
    else if (known && small_height(ray, walk) >= LEVEL_${N}_LOG2_CELL)
      return stop_with(walk, sample_${NEXT}(value));
%end
    else if (known && intersect_${NEXT}(ray, walk, value))
      return true;
  }
  return false;
}
