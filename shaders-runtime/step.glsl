// Steps from one cell of the ray to the next. Where float32 is not sure of one, it is done again in exact arithmetic.

// Steps over the empty cube of `side` voxels at `corner`.
void step_over(const Ray ray, inout Walk walk, ivec3 corner, int side) {
  bool sure;
  Crossing crossing = leave_cube(ray, corner, side, sure);
  land(ray, walk, crossing, corner + crossing.step * side, side, sure);
  if (!sure)
    walk = step_exactly(ray, walk, corner, side);
  count_step(walk);
}

// Steps from an empty cell of a grid to the first cell whose L1 distance is not below `distance`, or that lies outside
// the grid; no lookup is needed on the way.
void march(const Ray ray, inout Walk walk, ivec3 low, ivec3 cell, ivec3 log2_size, int log2_cell, uint distance) {
  ivec3 start = low + (cell << log2_cell);
  int side = 1 << log2_cell;
  int left = int(distance);
  bool sure = true;
  Crossing crossing;
  // The condition stands at the head: Mesa 22.3's llvmpipe lets lanes that leave a loop further down run on.
  while (sure && left > 0) {
    crossing = leave_cube(ray, low + (cell << log2_cell), side, sure);
    cell += crossing.step;
    ivec3 moved = abs(crossing.step);
    left = in_grid(cell, log2_size) ? left - max(moved.x + moved.y + moved.z, 1) : 0;
  }
  land(ray, walk, crossing, low + (cell << log2_cell), side, sure);
  if (!sure)
    walk = step_exactly(ray, walk, start, side);
  count_step(walk);
}
