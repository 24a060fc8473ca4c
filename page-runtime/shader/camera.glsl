// The camera.

// Where the ray through a place begins, from the eye.
vec3 aside(vec2 place) { return given.is_parallel != 0 ? given.right * place.x + given.up * place.y : vec3(0.0); }

vec3 way(vec2 place) {
  return normalize(given.is_parallel != 0 ? given.front : given.front + given.right * place.x + given.up * place.y);
}

// Where the first ray of a pixel has met the volume, from the eye.
vec3 point_of(ivec2 at, uint first) {
  vec2 place = (vec2(at) + 0.5) / vec2(given.size) * 2.0 - 1.0;
  return aside(place) + way(place) * uintBitsToFloat(first & ~0xfffu);
}
