// Steps in plain float32: always sure, and wrong only by rounding at a cell's boundary.

// How the ray leaves cells through the first of the faces ahead. Of several that it passes at once, rising coordinates come
// first.
Exit leave(const Ray ray, vec3 face) {
  vec3 t = (face - ray.origin) * ray.inverse;
  float first = min_of(t);
  ivec3 passed = -ivec3(equal(t, vec3(first)));
  ivec3 risen = passed & ray.ahead;
  passed = (risen.x | risen.y | risen.z) != 0 ? risen : passed;
  return Exit(first, notEqual(passed, ivec3(0)), true);
}

// The cell that a ray comes to where it leaves others, of which `cell` is one, by one of the faces ahead. Rounding leads
// neither back nor beyond another face.
ivec3 cell_beyond(const Ray ray, ivec3 cell, vec3 face, inout Exit leaving) {
  vec3 beyond = face + ray.beyond;
  vec3 first = vec3(cell);
  vec3 last = beyond - vec3(ray.heading);
  vec3 point = ray.origin + leaving.t * ray.direction;
  vec3 whole = floor(point);
  // Where a coordinate falls through a face, others that stand on a boundary have fallen through it too.
  ivec3 fallen = -ivec3(leaving.passed) & ~ray.ahead;
  if ((fallen.x | fallen.y | fallen.z) != 0)
    whole += mix(vec3(0.0f), ray.beyond, equal(point, whole));
  whole = max(min(whole, mix(last, first, ray.falls)), mix(first, last, ray.falls)); // First, if the coordinate stays.
  return ivec3(mix(whole, beyond, leaving.passed));
}
