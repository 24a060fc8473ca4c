// Steps in plain float32: wrong only by rounding at a cell's boundary. Cells are half-open, so where several
// coordinates cross a face at one t, rising ones change cell first, falling ones just after.

// The next change of cell.
struct Crossing {
  float t;
  ivec3 step;  // The change, a cell at most on each axis.
  bool rising; // Only rising coordinates change: those that fall may still stand on a boundary.
};

// How the ray leaves the cube of `side` voxels at `corner`.
Crossing leave_cube(const Ray ray, ivec3 corner, int side) {
  vec3 face = vec3(corner + ray.ahead * side);
  vec3 t = mix(vec3(INFINITY), (face - ray.origin) * ray.inverse, ray.moves);
  Crossing crossing;
  crossing.t = min(min(t.x, t.y), t.z);
  ivec3 crossed = ivec3(equal(t, vec3(crossing.t)));
  ivec3 risen = crossed * ray.ahead;
  crossing.rising = risen != ivec3(0);
  crossing.step = crossing.rising ? risen : crossed * ray.heading;
  return crossing;
}

// The voxel coordinates of the point at t, before rounding errors are bounded.
vec3 cell_at(const Ray ray, float t, bool rising) {
  vec3 point = ray.origin + t * ray.direction;
  vec3 cell = floor(point);
  return rising ? cell : mix(cell, ceil(point) - 1.0, ray.falls);
}

// Puts the walk into the cube of `side` voxels at `corner` that a crossing leads to.
void land(const Ray ray, inout Walk walk, const Crossing crossing, ivec3 corner, int side) {
  ivec3 last = corner + (side - 1);
  ivec3 least = mix(max(corner, walk.cell), corner, ray.falls);
  ivec3 most = mix(min(last, walk.cell), last, greaterThan(ray.ahead, ivec3(0)));
  // An axis that has just been crossed is on its face, whatever rounding says.
  least = mix(least, last, lessThan(crossing.step, ivec3(0)));
  most = mix(most, corner, greaterThan(crossing.step, ivec3(0)));
  vec3 cell = clamp(cell_at(ray, crossing.t, crossing.rising), vec3(least), vec3(most));
  walk.cell = ivec3(cell);
  walk.t = max(walk.t, crossing.t);
}

// Steps over the empty cube of `side` voxels at `corner`.
void step_over(const Ray ray, inout Walk walk, ivec3 corner, int side) {
  Crossing crossing = leave_cube(ray, corner, side);
  if (side == 1) {
    walk.cell = corner + crossing.step;
    walk.t = max(walk.t, crossing.t);
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

// Puts the walk into the first cell of [0, size)^3 on the ray; false if there is none.
bool enter_volume(const Ray ray, inout Walk walk, ivec3 size) {
  vec3 upper = vec3(size);
  bvec3 rises = greaterThan(ray.ahead, ivec3(0));
  bvec3 below = lessThan(ray.origin, vec3(0.0));
  bvec3 above = greaterThanEqual(ray.origin, upper);
  if (any(mix(mix(above, below, ray.falls), bvec3(ivec3(below) | ivec3(above)), not(ray.moves))))
    return false;

  bvec3 outside = mix(below, above, ray.falls);
  vec3 t_in = mix(vec3(0.0), (mix(vec3(0.0), upper, ray.falls) - ray.origin) * ray.inverse, outside);
  vec3 t_out = mix(vec3(INFINITY), (mix(vec3(0.0), upper, rises) - ray.origin) * ray.inverse, ray.moves);
  float t = max(max(t_in.x, t_in.y), t_in.z);
  if (!(t < INFINITY))
    return false;

  // A coordinate that falls into the volume is there just after t, when one that is to leave at t has left.
  bvec3 entered = bvec3(ivec3(outside) * ivec3(equal(t_in, vec3(t))));
  bool rising = !any(bvec3(ivec3(entered) * ivec3(ray.falls)));
  bvec3 left = lessThanEqual(t_out, vec3(t));
  if (rising)
    left = mix(left, lessThan(t_out, vec3(t)), ray.falls);
  if (any(left))
    return false;

  vec3 cell = clamp(cell_at(ray, t, rising), vec3(0.0), upper - 1.0);
  cell = mix(cell, mix(vec3(0.0), upper - 1.0, ray.falls), entered);
  walk.cell = ivec3(cell);
  walk.t = t;
  return true;
}
