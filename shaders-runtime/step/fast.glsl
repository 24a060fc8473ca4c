// Steps in plain float32: always sure, and wrong only by rounding at a cell's boundary.

// How the ray leaves cells through the first of the faces ahead. Of several that it passes at once, rising coordinates come
// first: to the bits of other t, whose order is that of numbers, one is added.
Exit leave(const Ray ray, vec3 face) {
  ivec3 t = floatBitsToInt((face - ray.origin) * ray.inverse) + (ray.ahead + 1);
  int first = min(min(t.x, t.y), t.z);
  return Exit(intBitsToFloat(first), equal(t, ivec3(first)), true);
}

// The cell that a ray comes to where it leaves others, of which `cell` is one, by one of the faces ahead. Rounding leads
// neither back nor beyond another face.
ivec3 cell_beyond(const Ray ray, ivec3 cell, vec3 face, inout Exit leaving) {
  ivec3 beyond = ivec3(face + ray.beyond);
  ivec3 last = beyond - ray.heading;
  vec3 point = ray.origin + leaving.t * ray.direction;
  ivec3 whole = ivec3(floor(point));
  // Where a coordinate falls through a face, others that stand on a boundary have fallen through it too.
  ivec3 fallen = mix(ivec3(0), ~ray.ahead, leaving.passed);
  whole += mix(ivec3(0), ~ray.ahead & (fallen.x | fallen.y | fallen.z), equal(vec3(whole), point));
  whole = max(min(whole, mix(last, cell, ray.falls)), mix(cell, last, ray.falls)); // The cell's, if the coordinate stays.
  return mix(whole, beyond, leaving.passed);
}
