// Steps from an empty cell to the first whose L1 distance is not below `left`, or that lies outside the sub-volume; no
// lookup is needed on the way.
void march_level_${N}(const Ray ray, inout Walk walk, int left) {
  const int side = 1 << LEVEL_${N}_LOG2_CELL;
  ivec3 corner = corner_of(walk.cell, LEVEL_${N}_LOG2_CELL);
  bool sure = true;
  Crossing crossing;
  // The condition stands at the head: Mesa 22.3's llvmpipe lets lanes that leave a loop further down run on.
  while (sure && left > 0) {
    crossing = leave_cube(ray, corner, side, sure);
    corner += crossing.step * side;
    ivec3 moved = abs(crossing.step);
    left = within_level_${N}(walk.cell, corner) ? left - max(moved.x + moved.y + moved.z, 1) : 0;
  }
  land_or_settle(ray, walk, crossing, corner, side, Gap(LEVEL_${N}_LOG2_CELL, 1), sure);
}

