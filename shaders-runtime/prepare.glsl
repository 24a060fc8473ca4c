// A ray as given, made ready for walking.

const float LEAST_COMPONENT = 1.0f / 1152921504606846976.0f / 1099511627776.0f; // 2^-100.

// Most rays are ordinary: float32 walks with them as they are, and nothing overflows or is lost on the way. Their direction is of a
// moderate length, 2^-40 to 2^40, all their numbers are 0 or at least 2^-80, none of their coordinates is that of the volume's last faces,
// and they begin within 2^45 voxels, or near the volume if rays from far away are not moved.
bool is_ordinary(uvec3 origin, uvec3 direction) {
  const uint SHORT_BITS = 0x2b800000u; // Of 2^-40.
  const uint RANGE = 0x28000000u;      // From there to 2^40.
  const uint TINY_BITS = 0x17800000u;  // Of 2^-80.
  const uint FAR_BITS = 0x56000000u;   // Of 2^45.
  uvec3 place = origin & ~SIGN_BIT;
  uvec3 size = direction & ~SIGN_BIT;
  bool is_moderate = max(max(size.x, size.y), size.z) - SHORT_BITS < RANGE;
  bool is_large = all(greaterThanEqual(min(place - 1u, size - 1u), uvec3(TINY_BITS - 1u)));
  bool is_near = all(lessThan(place, uvec3(COMES_NEAR ? FAR_BITS : floatBitsToUint(far_away()))));
  bool is_on_face = any(equal(origin, floatBitsToUint(vec3(VOLUME_SIZE))));
  return is_moderate && is_large && is_near && !is_on_face;
}

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

Ray prepare_ray(uvec3 origin, uvec3 direction, bool ordinary) {
  Ray ray;
  ray.given_origin = origin;
  ray.given_direction = direction;
  ray.plain = ordinary;
  ray.moves = notEqual(direction & ~SIGN_BIT, uvec3(0u));
  vec3 component = uintBitsToFloat(direction);
  if (SETTLES && !ordinary) {
    ray.plain = are_plain(origin) && are_plain(direction);
    component = mix(vec3(1.0f), vec3(-1.0f), greaterThan(direction, uvec3(SIGN_BIT))) * scaled_exactly(direction & ~SIGN_BIT);
  }
  component = mix(vec3(LEAST_COMPONENT), component, ray.moves);
  ivec3 sign = floatBitsToInt(component) >> 31;
  ray.origin = ${real3}(uintBitsToFloat(origin));
  ray.direction = ${real3}(component);
  ray.inverse = 1.0f / ray.direction;
  ray.late = ${real3}(0.0f);
  ray.falls = lessThan(sign, ivec3(0));
  ray.heading = sign | 1;
  ray.beyond = ${real3}(sign);
  ray.ahead = ~sign;
  ray.octant = octant_of(ray.ahead);
  return ray;
}
