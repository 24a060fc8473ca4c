// The parts of a direction that walking needs, scaled so that its largest component is in [1, 2).
Ray prepare_ray(uvec3 origin, uvec3 direction) {
  Ray ray;
  ray.given_origin = origin;
  ray.given_direction = direction;
  ray.origin = uintBitsToFloat(origin);
  ivec3 exponent;
  int largest = -1000;
  for (int axis = 0; axis < 3; axis++) {
    uint significand = significand_of(direction[axis]);
    ray.moves[axis] = significand != 0u;
    ray.falls[axis] = significand != 0u && direction[axis] >= SIGN_BIT;
    exponent[axis] = exponent_of(direction[axis]) + findMSB(significand);
    largest = significand != 0u ? max(largest, exponent[axis]) : largest;
  }
  for (int axis = 0; axis < 3; axis++) {
    uint significand = significand_of(direction[axis]);
    float size = float(significand) * power_of_two(-findMSB(significand)) * power_of_two(max(exponent[axis] - largest, -60));
    float component = ray.falls[axis] ? -size : size;
    ray.direction[axis] = ray.moves[axis] ? component : 0.0f;
    ray.inverse[axis] = ray.moves[axis] ? 1.0f / component : 1.0f;
  }
  ray.heading = ivec3(ray.moves) - 2 * ivec3(ray.falls);
  ray.ahead = -max(ray.heading, ivec3(0));
  return ray;
}

bool is_finite(uvec3 bits) { return is_finite(bits.x) && is_finite(bits.y) && is_finite(bits.z); }

// Traces one ray from where its walk is, if that has begun, and gives its t. Word 0 leads to level 1, unless the volume
// is empty.
bool trace(uvec3 origin, uvec3 direction, inout Walk walk, inout uint t) {
  uint root = load_word(0u);
  if (root == 0u || !is_finite(origin) || !is_finite(direction))
    return false;
  // A ray that goes nowhere can hit its own cell alone: let it go anywhere and take no later hit.
  bool stands = ((direction.x | direction.y | direction.z) & ~SIGN_BIT) == 0u;
  Ray ray = prepare_ray(origin, stands ? uvec3(floatBitsToUint(1.0f), 0u, 0u) : direction);
  Walk start = walk;
  if (!enter_volume(ray, start))
    return false;
  if (!is_in_volume(walk.cell))
    walk = start;
%if settles-outside
  bool hit = false;
  bool goes_on = true;
  while (goes_on) {
    if (walk.open >= 0) {
      Gap gap = Gap(walk.open & 31, walk.open >> 5);
      walk.open = -1;
      walk.cell = ~walk.cell;
      walk = settled(ray, walk, gap);
    }
    // What was settled may have been the last step inside.
    hit = is_in_volume(walk.cell) && intersect_level_1(ray, walk, root);
    goes_on = walk.open >= 0;
  }
%if cut
  // The device ended the loop above.
  if (walk.open >= 0)
    walk.cell = ~walk.cell;
%end
%else
  bool hit = intersect_level_1(ray, walk, root);
%end
  if (walk.axis < 0)
    return hit;
  if (stands) {
    walk.cell = ivec3(-1);
    return false;
  }
  if (hit)
    t = crossing_time(ray, walk.axis, entered_face(ray, walk));
  return hit;
}
