// Steps from one cell of the ray to the next.

// How the ray leaves the cube of `side` voxels at `corner`.
Crossing leave_cube(const Ray ray, ivec3 corner, int side) {
  ivec3 face = corner + ray.ahead * side;
  vec3 t = mix(vec3(NEVER), (vec3(face) - ray.origin) * ray.inverse, ray.moves);
  ivec3 crossed = first_crossed(ray, face, t);
  ivec3 risen = crossed * ray.ahead;
  Crossing crossing;
  crossing.rising = risen != ivec3(0);
  crossing.step = crossing.rising ? risen : crossed * ray.heading;
  crossing.axis = crossing.step.x != 0 ? 0 : crossing.step.y != 0 ? 1 : 2;
  crossing.t = t[crossing.axis];
  crossing.face = face[crossing.axis];
  return crossing;
}

// Puts the walk into the cube of `side` voxels at `corner` that a crossing leads to.
void land(const Ray ray, inout Walk walk, const Crossing crossing, ivec3 corner, int side) {
  ivec3 last = corner + (side - 1);
  ivec3 least = mix(max(corner, walk.cell), corner, ray.falls);
  ivec3 most = mix(min(last, walk.cell), last, greaterThan(ray.ahead, ivec3(0)));
  // An axis that has just been crossed is on its face.
  least = mix(least, last, lessThan(crossing.step, ivec3(0)));
  most = mix(most, corner, greaterThan(crossing.step, ivec3(0)));
  walk.cell = cell_after(ray, crossing, least, most);
  walk.axis = crossing.axis;
}

// Steps over the empty cube of `side` voxels at `corner`.
void step_over(const Ray ray, inout Walk walk, ivec3 corner, int side) {
  Crossing crossing = leave_cube(ray, corner, side);
  if (side == 1) {
    walk.cell = corner + crossing.step;
    walk.axis = crossing.axis;
  } else {
    land(ray, walk, crossing, corner + crossing.step * side, side);
  }
}

// Steps from an empty cell of a grid to the first cell whose L1 distance is not below `distance`, or that lies outside
// the grid; no lookup is needed on the way.
void march(const Ray ray, inout Walk walk, ivec3 low, ivec3 cell, ivec3 log2_size, int log2_cell, uint distance) {
  int left = int(distance);
  Crossing crossing;
  // The condition stands at the head: Mesa 22.3's llvmpipe lets lanes that leave a loop further down run on.
  while (left > 0) {
    crossing = leave_cube(ray, low + (cell << log2_cell), 1 << log2_cell);
    cell += crossing.step;
    ivec3 moved = abs(crossing.step);
    left = in_grid(cell, log2_size) ? left - (moved.x + moved.y + moved.z) : 0;
  }
  land(ray, walk, crossing, low + (cell << log2_cell), 1 << log2_cell);
}
