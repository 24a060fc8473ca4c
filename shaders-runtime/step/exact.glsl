// Steps that are exact for every ray: float32 where its error bound decides, integers elsewhere.

// How the ray leaves the cube of `side` voxels at `corner`. Not sure if float32 cannot tell which face it passes first.
Crossing leave_cube(const Ray ray, ivec3 corner, int side, out bool sure) {
  ivec3 face = corner + (ray.ahead & side);
  vec3 t = times_of(ray, face);
  Crossing crossing;
  crossing.t = min_of(t);
  bvec3 crossed = lessThanEqual(t, vec3(crossing.t + (crossing.t * ROUNDINGS + ray.slack)));
  ivec3 count = ivec3(crossed);
  sure = count.x + count.y + count.z == 1;
  crossing.axis = crossed.z ? 2 : crossed.y ? 1 : 0;
  crossing.step = mix(ivec3(0), ray.heading, crossed);
  crossing.face = face[crossing.axis];
  crossing.rising = !ray.falls[crossing.axis];
  return crossing;
}

// Puts the walk into the cube of `side` voxels at `corner` that a crossing leads to, unless float32 cannot tell to which
// of its cells. A coordinate just below the cube, or in its last half cell, belongs to the cube's first or last cell.
void land(const Ray ray, inout Walk walk, const Crossing crossing, ivec3 corner, int side, inout bool sure) {
  ivec3 cell = corner;
  if (side > 1) {
    vec3 least = vec3(corner);
    vec3 point = clamp(ray.lowest + crossing.t * ray.direction, least, least + (float(side) - 0.5f));
    vec3 whole = floor(point);
    sure = sure && all(lessThan(point - whole, 1.0f - ray.doubt));
    cell = ivec3(whole);
  }
  if (sure) {
    walk.cell = cell;
    walk.axis = crossing.axis;
  }
}

// Steps over the empty cube of `side` voxels at `corner` where float32 was not sure how: settles which faces the ray
// passes first, axis by axis, and then by bisection to which cell it comes. All questions are asked at one place, since
// devices of wide vectors run through it at every step. Where the device cuts it short, the walk stays where it is.
OUT_OF_LINE Walk step_exactly(const Ray ray, Walk walk, ivec3 corner, int side) {
  ivec3 face = corner + (ray.ahead & side);
  int first = ray.moves.x ? 0 : ray.moves.y ? 1 : 2;
  bvec3 crossed = bvec3(false);
  Crossing crossing;
  Range range = Range(ivec3(0), ivec3(1));
  int next = 0;
  int order = 0;
  while (order != CUT_SHORT && range.least != range.most) {
    bool orders = next < 3;
    int axis = orders ? next : undecided_axis(range);
    int at = orders ? face[axis] : middle_of(range, axis);
    order = compare_crossings(ray, axis, at, first, face[first]);
    if (!orders) {
      narrow(ray, crossing, axis, at, order, range);
    } else {
      if (ray.moves[axis] && order <= 0) {
        crossed = order < 0 ? bvec3(false) : crossed;
        crossed[axis] = true;
        first = axis;
      }
      next++;
      if (next == 3) {
        crossing = crossing_of(ray, face, min_of(times_of(ray, face)), crossed);
        ivec3 target = corner + crossing.step * side;
        range = approximate_cell(ray, crossing, Range(target, target + (side - 1)));
      }
    }
  }
  if (order != CUT_SHORT && range.least == range.most) {
    walk.cell = range.least;
    walk.axis = crossing.axis;
  }
  return walk;
}
