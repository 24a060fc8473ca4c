// Steps in plain float32: wrong only by rounding at a cell's boundary.

// The axes whose coordinates pass their face first, at t: 1, others 0.
ivec3 first_crossed(const Ray ray, ivec3 face, vec3 t) {
  return ivec3(equal(t, vec3(min(min(t.x, t.y), t.z))));
}

// The cell, within [least, most], that the ray is in once a crossing has happened.
ivec3 cell_after(const Ray ray, const Crossing crossing, ivec3 least, ivec3 most) {
  vec3 point = ray.origin + crossing.t * ray.direction;
  vec3 cell = floor(point);
  if (!crossing.rising)
    cell = mix(cell, ceil(point) - 1.0f, ray.falls);
  return ivec3(clamp(cell, vec3(least), vec3(most)));
}
