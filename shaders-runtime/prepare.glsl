// A ray as given, made ready for the traversal.

const float LEAST_COMPONENT = 1.0f / 1099511627776.0f / 1099511627776.0f; // 2^-80.

// Most rays are ordinary: float32 traverses with them as they are, and nothing overflows or is lost on the way. Their direction is scaled
// without a rounding, all numbers of theirs are then 0 or at least 2^-80, and they begin within 2^45 voxels, or near the volume if
// rays from far away are not moved. `longest` has the bits of the direction's longest component, and `component` is the direction
// once it is scaled.
bool is_ordinary(uvec3 origin, uint longest, vec3 component) {
  const uint SHORTEST = 0x00800000u; // The bits of 2^-126, below which devices may keep no number.
  const uint RANGE = 0x7e800000u;    // From there to 2^127, where no number is left to scale by.
  const uint FAR_BITS = 0x56000000u; // Of 2^45.
  uvec3 place = origin & ~SIGN_BIT;
  uvec3 least = min(place - 1u, floatBitsToUint(abs(component)));
  uint farthest = max(max(place.x, place.y), place.z);
  bool is_scaled = longest - SHORTEST < RANGE;
  bool is_large = min(min(least.x, least.y), least.z) >= floatBitsToUint(LEAST_COMPONENT);
  bool is_near = farthest < (COMES_NEAR ? FAR_BITS : floatBitsToUint(far_away()));
  return is_scaled && is_large && is_near;
}

// Whether no number of a ray but 0 is so small that products of its numbers are rounded by what is no float32.
bool are_moderate(bvec3 moves, uvec3 origin, vec3 component) {
  const float LEAST = 1.0f / 1099511627776.0f; // 2^-40.
  uvec3 least = min((origin & ~SIGN_BIT) - 1u, mix(uvec3(INFINITY_BITS), floatBitsToUint(abs(component)), moves));
  return min(min(least.x, least.y), least.z) >= floatBitsToUint(LEAST);
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

// The inverse of a component, within 1.0001 roundings where sums and products are rounded to nearest, and the device's own inverse within
// some: what that leaves of 1 is known exactly.
float mended_inverse(float component) {
  float inverse = 1.0f / component;
  precise float one = component * inverse;
  precise float rest = (1.0f - one) - lost_of(one, component, inverse);
  precise float mended = inverse + inverse * rest;
  return mended;
}

// Makes a ray ready, whose direction is scaled by a power of two so that its longest component is in [1, 2).
Ray prepare_ray(uvec3 origin, uvec3 direction, out bool ordinary) {
  Ray ray;
  ray.given_origin = origin;
  ray.given_direction = direction;
  uvec3 size = direction & ~SIGN_BIT;
  uint longest = longest_of(direction);
  ray.moves = notEqual(size, uvec3(0u));
  vec3 component = uintBitsToFloat(direction) * uintBitsToFloat(0x7f000000u - (longest & INFINITY_BITS));
  component = mix(vec3(LEAST_COMPONENT), component, ray.moves);
  ordinary = is_ordinary(origin, longest, component);
  ray.plain = ordinary;
  ray.is_moderate = ordinary && are_moderate(ray.moves, origin, component);
  if (EXACT_FALLBACK && !ordinary) {
    ray.plain = are_plain(origin) && are_plain(direction);
    component = mix(vec3(1.0f), vec3(-1.0f), greaterThan(direction, uvec3(SIGN_BIT))) * scaled_exactly(size);
    component = mix(vec3(LEAST_COMPONENT), component, ray.moves);
  }
  ivec3 sign = floatBitsToInt(component) >> 31;
  ray.origin = real3(uintBitsToFloat(origin));
  ray.direction = real3(component);
  ray.inverse = 1.0f / ray.direction;
  if (NEAREST)
    ray.inverse = real3(mended_inverse(component.x), mended_inverse(component.y), mended_inverse(component.z));
  ray.late = real3(0.0f);
  ray.falls = lessThan(sign, ivec3(0));
  ray.heading = sign | 1;
  ray.beyond = real3(sign);
  ray.ahead = ~sign;
  ray.octant = octant_of(ray.ahead);
  return ray;
}
