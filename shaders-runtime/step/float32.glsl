// Steps in plain float32: always sure, and wrong only by rounding at a cell's boundary.

// The axes whose coordinates pass a face first: 1, others 0.
ivec3 first_crossed(const Ray ray, vec3 t, inout bool sure) {
  sure = true;
  return ivec3(equal(t, vec3(min(min(t.x, t.y), t.z))));
}

// The cell, within a range, that the ray is in once a crossing has happened.
ivec3 cell_after(const Ray ray, const Crossing crossing, const Range range, inout bool sure) {
  vec3 point = ray.origin + crossing.t * ray.direction;
  vec3 cell = floor(point);
  if (!crossing.rising)
    cell = mix(cell, ceil(point) - 1.0f, ray.falls);
  return ivec3(clamp(cell, vec3(range.least), vec3(range.most)));
}

// For steps that are not sure, of which there are none.
void step_exactly(const Ray ray, inout Walk walk, ivec3 corner, int side) {}
