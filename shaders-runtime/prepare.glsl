// A ray as given, made ready for walking.

const float LEAST_COMPONENT = 1.0f / 1152921504606846976.0f; // 2^-60.

// The magnitudes of a direction, divided by a power of two that leaves the largest in [1, 2), for numbers of any size.
OUT_OF_LINE vec3 scaled_exactly(uvec3 size) {
  ivec3 exponent;
  int largest = -1000;
  for (int axis = 0; axis < 3; axis++) {
    uint significand = significand_of(size[axis]);
    exponent[axis] = exponent_of(size[axis]) + findMSB(significand);
    largest = significand != 0u ? max(largest, exponent[axis]) : largest;
  }
  vec3 result;
  for (int axis = 0; axis < 3; axis++) {
    uint significand = significand_of(size[axis]);
    result[axis] = float(significand) * power_of_two(-findMSB(significand)) * power_of_two(max(exponent[axis] - largest, -60));
  }
  return result;
}

// The same, by float32 where that is exact.
vec3 scaled(uvec3 size, bool plain) {
  uint exponent = max(max(size.x, size.y), size.z) & INFINITY_BITS;
  vec3 result = uintBitsToFloat(size) * uintBitsToFloat(0x7f000000u - exponent);
  if (SETTLES && !plain)
    result = scaled_exactly(size);
  return max(result, LEAST_COMPONENT);
}

Ray prepare_ray(uvec3 origin, uvec3 direction) {
  Ray ray;
  uvec3 size = direction & ~SIGN_BIT;
  ray.given_origin = origin;
  ray.given_direction = direction;
  // Of a direction of 2^127 and more, float32 has no inverse to scale by.
  ray.plain = are_plain(origin) && are_plain(direction) && max(max(size.x, size.y), size.z) < 0x7f000000u;
  ray.origin = ${real3}(uintBitsToFloat(origin));
  ray.moves = notEqual(size, uvec3(0u));
  ray.falls = greaterThan(direction, uvec3(SIGN_BIT));
  vec3 component = scaled(size, ray.plain);
  component = mix(component, -component, ray.falls);
  ray.direction = mix(${real3}(0.0f), ${real3}(component), ray.moves);
  ray.inverse = mix(${real3}(1.0f), 1.0f / ${real3}(component), ray.moves);
  ray.late = ${real3}(0.0f);
  ray.heading = ivec3(ray.moves) - 2 * ivec3(ray.falls);
  ray.ahead = -max(ray.heading, ivec3(0));
  ray.beyond = -${real3}(ray.falls);
  return ray;
}
