// Steps that are exact for every ray: float32 where its error bound decides, integers elsewhere.

// The axis whose coordinate passes a face first: 1, others 0. Not sure if the next is so close that float32 cannot tell.
ivec3 first_crossed(const Ray ray, vec3 t, inout bool sure) {
  float first = min(min(t.x, t.y), t.z);
  float next = max(min(t.x, t.y), min(max(t.x, t.y), t.z));
  sure = next - first > next * ROUNDINGS + ray.slack;
  return ivec3(equal(t, vec3(first)));
}

// The cell, within a range, that the ray is in once a crossing has happened. Not sure if float32 cannot tell.
ivec3 cell_after(const Ray ray, const Crossing crossing, const Range range, inout bool sure) {
  Range cell = approximate_cell(ray, crossing, range);
  sure = sure && cell.least == cell.most;
  return cell.least;
}

// The axes whose coordinates pass their face first: 1, others 0.
OUT_OF_LINE ivec3 settle_first(const Ray ray, ivec3 face) {
  int first = ray.moves.x ? 0 : ray.moves.y ? 1 : 2;
  ivec3 crossed = ivec3(0);
  crossed[first] = 1;
  for (int axis = first + 1; axis < 3; axis++) {
    int order = ray.moves[axis] ? compare_crossings(ray, axis, face[axis], first, face[first]) : 1;
    if (order < 0) {
      crossed = ivec3(0);
      first = axis;
    }
    if (order <= 0)
      crossed[axis] = 1;
  }
  return crossed;
}

// Steps over the empty cube of `side` voxels at `corner` where float32 was not sure how.
void step_exactly(const Ray ray, inout Walk walk, ivec3 corner, int side) {
  ivec3 face = corner + ray.ahead * side;
  Crossing crossing = crossing_of(ray, face, times_of(ray, face), settle_first(ray, face));
  Range range = landing_range(ray, walk, crossing, corner + crossing.step * side, side);
  walk.cell = settle(ray, crossing, approximate_cell(ray, crossing, range));
  walk.axis = crossing.axis;
}
