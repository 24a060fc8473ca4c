// What lies between two moments of a ray, tmin and tmax.

// Moments as bits of float32 that are not below 0. Nothing lies between them if tmin > tmax.
struct Bounds {
  uint tmin;
  uint tmax;
};

// The bits of a moment, for which one before 0 is as good as 0.
uint moment_of(uint bits) { return bits > SIGN_BIT && bits <= (SIGN_BIT | INFINITY_BITS) ? 0u : bits & ~SIGN_BIT; }

// The bounds that two float32 tell. A NaN is in no interval, and no voxel is entered at +inf.
Bounds bounds_between(uint tmin, uint tmax) {
  Bounds bounds = Bounds(moment_of(tmin), moment_of(tmax));
  bool are_bounds = bounds.tmin < INFINITY_BITS && tmax <= SIGN_BIT && bounds.tmax <= INFINITY_BITS;
  if (!are_bounds)
    bounds = Bounds(1u, 0u);
  return bounds;
}

const int UNDECIDED = 2; // No order: it cannot be told here.

// The order of the moment at which a coordinate passes a face and another moment, where
// (face - origin) * 1 - moment * direction has this sign.
int order_by_sign(const Ray ray, int axis, int sign_of_difference) {
  return ray.falls[axis] ? -sign_of_difference : sign_of_difference;
}

OUT_OF_LINE int compare_moment_exactly(const Ray ray, int axis, int face, uint moment) {
  uint one = floatBitsToUint(1.0f);
  Sum difference = sum_of_products(uvec4(floatBitsToUint(float(face)), ray.given_origin[axis] ^ SIGN_BIT, moment ^ SIGN_BIT, 0u),
                                   uvec4(one, one, ray.given_direction[axis], 0u));
  return !CUT || difference.complete ? order_by_sign(ray, axis, sign_of(difference)) : UNDECIDED;
}

// What is known of the order of two moments: that one is later or sooner, or, of neither, that they are the same.
int order_decided(const Ray ray, int axis, uint moment, bool later, bool sooner, bool is_exact) {
  bool decided =
      (later || sooner || is_exact) && ray.plain && moment - 1u >= 0x7fffffu; // Devices may not keep a denormal moment.
  return decided ? order_by_sign(ray, axis, later ? 1 : sooner ? -1 : 0) : UNDECIDED;
}

// The same by doubles, of which the product is exact and the distance is rounded once, if at all; four roundings of 2^-53 are far more.
int compare_moment_by_doubles(const Ray ray, int axis, int face, uint moment) {
  Way to_face = way_to(double(face), exactly(ray.given_origin[axis]));
  double way = exactly(moment) * exactly(ray.given_direction[axis]);
  double bound =
      to_face.is_exact ? double(0.0f) : (abs(to_face.distance) + abs(way)) * double(1.0f / 1125899906842624.0f); // 2^-50.
  double apart = to_face.distance - way;
  return order_decided(ray, axis, moment, apart > bound, apart < -bound, to_face.is_exact);
}

// The same by sums of two float32 (pairs.glsl), wrong by less than 2^-44 of the distance and the way together. The direction is the
// scaled one, and the moment counts in it.
int compare_moment_by_pairs(const Ray ray, int axis, int face, uint moment) {
  float t = uintBitsToFloat(moment) * uintBitsToFloat(longest_of(ray.given_direction) & INFINITY_BITS);
  float speed = float(ray.direction[axis]);
  Pair to_face = exact_sum(float(face), -uintBitsToFloat(ray.given_origin[axis]));
  precise float way = t * speed;
  float apart = (to_face.high - way) + (to_face.low - lost_of(way, t, speed));
  float bound = (abs(to_face.high) + abs(way)) * ERROR_BOUND;
  bool is_in_range = ray.is_moderate && t > 1e-9f && t < 1e12f;
  return order_decided(ray, axis, moment, is_in_range && apart > bound, is_in_range && apart < -bound, false);
}

// The same by float32, whose distance and way are rounded once each.
int compare_moment_by_floats(const Ray ray, int axis, int face, uint moment) {
  float distance = float(face) - uintBitsToFloat(ray.given_origin[axis]);
  float way = uintBitsToFloat(moment) * uintBitsToFloat(ray.given_direction[axis]);
  float bound = (abs(distance) + abs(way)) * float(ROUNDINGS);
  return order_decided(ray, axis, moment, distance - way > bound, distance - way < -bound, false);
}

int compare_moment(const Ray ray, int axis, int face, uint moment) {
  if (IEEE)
    return compare_moment_by_doubles(ray, axis, face, moment);
  return NEAREST ? compare_moment_by_pairs(ray, axis, face, moment) : compare_moment_by_floats(ray, axis, face, moment);
}

// Whether the ray enters the traversal's cell before a moment, -1, at it, 0, or after it, 1. UNDECIDED if only exact arithmetic can
// tell, and that is not at hand, or the device has cut it short.
int compare_entry(const Ray ray, const Traversal traversal, uint moment) {
  if (traversal.axis < 0)
    return moment == 0u ? 0 : -1;
  int face = entered_face(ray, traversal);
  int order = compare_moment(ray, traversal.axis, face, moment);
  if (EXACT_FALLBACK && order == UNDECIDED)
    order = compare_moment_exactly(ray, traversal.axis, face, moment);
  return order;
}

// Where the entry of the traversal's cell lies: before the bounds, -1, within them, 0, or after them, 1. UNDECIDED as above.
int place_of_entry(const Ray ray, const Traversal traversal, const Bounds bounds) {
  if (PACKETS && traversal.is_within)
    return 0;
  int order = bounds.tmin == 0u ? 0 : compare_entry(ray, traversal, bounds.tmin);
  if (order < 0 || order == UNDECIDED)
    return order;
  return bounds.tmax == INFINITY_BITS ? 0 : max(compare_entry(ray, traversal, bounds.tmax), 0);
}

// Where a ray is at a moment, wrong by less than `wrong` and a rounding of it.
struct Place {
  vec3 at;
  vec3 wrong;
  bool is_known; // It is not out of float32's reach.
};

// From any distance, as rays come near (near.glsl): with halves of 12 bits no product is rounded, and their sum with the origin is kept
// as two float32, of which the lower one loses less than 2^-43 of the way and the distance. Where rays do not come near, as nearly all
// begin there, or as a language has no `precise`, it is one float32.
Place place_at(const Ray ray, uint moment) {
  const uint UPPER = 0xfffff000u; // The bits of a float32 but the lowest 12 of its significand.
  vec3 origin = uintBitsToFloat(ray.given_origin);
  vec3 direction = uintBitsToFloat(ray.given_direction);
  float t = uintBitsToFloat(moment);
  vec3 way = t * direction;
  vec3 reach = abs(origin) + abs(way);
  bool is_known = all(lessThan(reach, vec3(NEVER)));
  if (!COMES_NEAR)
    return Place(origin + way, reach / 1048576.0f, is_known); // 2^20.
  vec3 upper = uintBitsToFloat(ray.given_direction & UPPER);
  float early = uintBitsToFloat(moment & UPPER);
  real3 high = real3(origin), low = real3(0.0f);
  move_by(real3(early * upper), high, low);
  move_by(real3(early * (direction - upper)), high, low);
  move_by(real3((t - early) * upper), high, low);
  move_by(real3((t - early) * (direction - upper)), high, low);
  return Place(vec3(high + low), reach / 1099511627776.0f, is_known); // 2^40.
}

// Moves a traversal that begins long before a moment to a cell that the ray comes to shortly before.
void skip_to(const Ray ray, inout Traversal traversal, uint moment) {
  const int WORTH_SKIPPING = 4; // In voxels.
  if (moment == 0u || !is_in_volume(traversal.cell))
    return;
  uvec3 size = ray.given_direction & ~SIGN_BIT;
  int axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
  Place place = place_at(ray, moment);
  if (!place.is_known)
    return;
  float before = place.at[axis] - float(ray.heading[axis]) * (2.0f + place.wrong[axis]); // By more than a few roundings.
  int face = int(floor(clamp(before, -1.0f, float(VOLUME_SIZE[axis] + 1))));
  int behind = face - int(ray.falls[axis]);
  if ((behind - traversal.cell[axis]) * ray.heading[axis] > WORTH_SKIPPING)
    traversal = behind_face(ray, traversal, traversal.cell, axis, face);
}

// Lets a traversal end shortly after a moment, where float32 can decide when that is.
void end_after(const Ray ray, inout Traversal traversal, uint moment) {
  if (!ray.plain || moment >= INFINITY_BITS || (moment != 0u && moment < 0x800000u))
    return;
  Place place = place_at(ray, moment);
  if (!place.is_known)
    return;
  vec3 after = place.at + vec3(ray.heading) * (2.0f + place.wrong);
  ivec3 last = ivec3(clamp(floor(after), vec3(0.0f), vec3(VOLUME_SIZE - 1)));
  traversal.begin = mix(ivec3(0), last, ray.falls);
  traversal.size = mix(VOLUME_SIZE, last + 1, greaterThan(ray.heading, ivec3(0))) - traversal.begin;
}

// Lets a traversal that is ready end shortly after its bounds. False, and a miss, if nothing lies between them.
bool bound_traversal(const Ray ray, inout Traversal traversal, const Bounds bounds) {
  if (bounds.tmin > bounds.tmax) {
    traversal.cell = ivec3(-1);
    traversal.pending_step = NO_PENDING_STEP;
    return false;
  }
  end_after(ray, traversal, bounds.tmax);
  return true;
}

// Goes on with a traversal to the first voxel that the ray enters within the bounds. A traversal of which that cannot be told stays where
// it is, in that voxel; one that has come beyond the bounds ends.
bool traverse_within(const Ray ray, inout Traversal traversal, uint root, const Bounds bounds) {
  bool found = false;
  int place = -1;
  while (place < 0) {
    found = (is_in_volume(traversal.cell) || traversal.pending_step >= 0) && continue_traversal(ray, traversal, root);
    place = found ? place_of_entry(ray, traversal, bounds) : 0;
    if (place < 0)
      step_over_voxel(ray, traversal);
  }
  if (found && place == 1)
    traversal.cell = ivec3(-1);
  if (!EXACT_FALLBACK && found && place == UNDECIDED)
    traversal.pending_step = RETRY;
  return found && place == 0;
}
