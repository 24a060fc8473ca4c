// Steps in plain float32: always sure, and wrong only by rounding at a cell's boundary.

// How the ray leaves the cube of `side` voxels at `corner`.
Crossing leave_cube(const Ray ray, ivec3 corner, int side, out bool sure) {
  ivec3 face = corner + (ray.ahead & side);
  vec3 t = times_of(ray, face);
  float first = min_of(t);
  sure = true;
  return crossing_of(ray, face, first, equal(t, vec3(first)));
}

// Puts the walk into the cube of `side` voxels at `corner` that a crossing leads to, and never back on any axis, which
// rounding alone could do.
void land(const Ray ray, inout Walk walk, const Crossing crossing, ivec3 corner, int side) {
  ivec3 cell = corner;
  if (side > 1) {
    vec3 least = vec3(corner);
    vec3 point = clamp(ray.origin + crossing.t * ray.direction, least, least + (float(side) - 0.5f));
    vec3 whole = floor(point);
    if (!crossing.rising)
      whole = mix(whole, max(ceil(point) - 1.0f, least), ray.falls);
    cell = ivec3(whole);
    cell = mix(max(cell, walk.cell), min(cell, walk.cell), ray.falls);
  }
  walk.cell = cell;
  walk.axis = crossing.axis;
}
