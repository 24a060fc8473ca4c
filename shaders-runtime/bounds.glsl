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

const int UNTOLD = 2; // No order: it cannot be told here.

// The order of the moment at which a coordinate passes a face and another moment, where
// (face - origin) * 1 - moment * direction has this sign.
int order_by_sign(const Ray ray, int axis, int sign_of_difference) {
  return ray.falls[axis] ? -sign_of_difference : sign_of_difference;
}

OUT_OF_LINE int compare_moment_exactly(const Ray ray, int axis, int face, uint moment) {
  uint one = floatBitsToUint(1.0f);
  Sum difference = sum_of_products(uvec4(floatBitsToUint(float(face)), ray.given_origin[axis] ^ SIGN_BIT, moment ^ SIGN_BIT, 0u),
                                   uvec4(one, one, ray.given_direction[axis], 0u));
  return !CUT || difference.complete ? order_by_sign(ray, axis, sign_of(difference)) : UNTOLD;
}

// What is known of the order of two moments: that one is later or sooner, or, of neither, that they are the same.
int order_told(const Ray ray, int axis, uint moment, bool later, bool sooner, bool is_exact) {
  bool told = (later || sooner || is_exact) && ray.plain && moment - 1u >= 0x7fffffu; // Devices may not keep a denormal moment.
  return told ? order_by_sign(ray, axis, later ? 1 : sooner ? -1 : 0) : UNTOLD;
}

// The same by doubles, of which the product is exact and the distance is rounded once, if at all; four roundings of 2^-53 are far more.
int compare_moment_by_doubles(const Ray ray, int axis, int face, uint moment) {
  Way to_face = way_to(double(face), exactly(ray.given_origin[axis]));
  double way = exactly(moment) * exactly(ray.given_direction[axis]);
  double doubt =
      to_face.is_exact ? double(0.0f) : (abs(to_face.distance) + abs(way)) * double(1.0f / 1125899906842624.0f); // 2^-50.
  double apart = to_face.distance - way;
  return order_told(ray, axis, moment, apart > doubt, apart < -doubt, to_face.is_exact);
}

// The same by float32, whose distance and way are rounded once each.
int compare_moment_by_floats(const Ray ray, int axis, int face, uint moment) {
  float distance = float(face) - uintBitsToFloat(ray.given_origin[axis]);
  float way = uintBitsToFloat(moment) * uintBitsToFloat(ray.given_direction[axis]);
  float doubt = (abs(distance) + abs(way)) * float(ROUNDINGS);
  return order_told(ray, axis, moment, distance - way > doubt, distance - way < -doubt, false);
}

int compare_moment(const Ray ray, int axis, int face, uint moment) {
  return IEEE ? compare_moment_by_doubles(ray, axis, face, moment) : compare_moment_by_floats(ray, axis, face, moment);
}

// Whether the ray enters the walk's cell before a moment, -1, at it, 0, or after it, 1. UNTOLD if only exact arithmetic can
// tell, and that is not at hand, or the device has cut it short.
int compare_entry(const Ray ray, const Walk walk, uint moment) {
  if (walk.axis < 0)
    return moment == 0u ? 0 : -1;
  int face = entered_face(ray, walk);
  int order = compare_moment(ray, walk.axis, face, moment);
  if (SETTLES && order == UNTOLD)
    order = compare_moment_exactly(ray, walk.axis, face, moment);
  return order;
}

// Where the entry of the walk's cell lies: before the bounds, -1, within them, 0, or after them, 1. UNTOLD as above.
int place_of_entry(const Ray ray, const Walk walk, const Bounds bounds) {
  if (PACKETS && walk.is_within)
    return 0;
  int order = bounds.tmin == 0u ? 0 : compare_entry(ray, walk, bounds.tmin);
  if (order < 0 || order == UNTOLD)
    return order;
  return bounds.tmax == INFINITY_BITS ? 0 : max(compare_entry(ray, walk, bounds.tmax), 0);
}

// Moves a walk that begins long before a moment to a cell that the ray comes to shortly before.
void skip_to(const Ray ray, inout Walk walk, uint moment) {
  const int WORTH_SKIPPING = 4; // In voxels.
  if (moment == 0u || !is_in_volume(walk.cell))
    return;
  uvec3 size = ray.given_direction & ~SIGN_BIT;
  int axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
  float origin = uintBitsToFloat(ray.given_origin[axis]);
  float way = uintBitsToFloat(moment) * uintBitsToFloat(ray.given_direction[axis]);
  float heading = float(ray.heading[axis]);
  float reach = abs(origin) + abs(way);
  if (!(reach < NEVER))
    return;
  float before = origin + way - heading * (2.0f + reach / 1048576.0f); // By more than a few roundings.
  int face = int(floor(clamp(before, -1.0f, float(VOLUME_SIZE[axis] + 1))));
  int behind = face - int(ray.falls[axis]);
  if ((behind - walk.cell[axis]) * ray.heading[axis] > WORTH_SKIPPING)
    walk = behind_face(ray, walk, walk.cell, axis, face);
}

// Lets a walk end shortly after a moment, where float32 can tell when that is.
void end_after(const Ray ray, inout Walk walk, uint moment) {
  if (!ray.plain || moment >= INFINITY_BITS || (moment != 0u && moment < 0x800000u))
    return;
  vec3 origin = uintBitsToFloat(ray.given_origin);
  vec3 way = uintBitsToFloat(moment) * uintBitsToFloat(ray.given_direction);
  vec3 room = 2.0f + (abs(origin) + abs(way)) / 1048576.0f;
  vec3 after = origin + way + vec3(ray.heading) * room;
  ivec3 last = ivec3(clamp(floor(after), vec3(0.0f), vec3(VOLUME_SIZE - 1)));
  walk.begin = mix(ivec3(0), last, ray.falls);
  walk.size = mix(VOLUME_SIZE, last + 1, greaterThan(ray.heading, ivec3(0))) - walk.begin;
}

// Lets a walk that is ready end shortly after its bounds. False, and a miss, if nothing lies between them.
bool bound_walk(const Ray ray, inout Walk walk, const Bounds bounds) {
  if (bounds.tmin > bounds.tmax) {
    walk.cell = ivec3(-1);
    walk.open = CLOSED;
    return false;
  }
  end_after(ray, walk, bounds.tmax);
  return true;
}

// Goes on with a walk to the first voxel that the ray enters within the bounds. A walk of which that cannot be told stays where
// it is, in that voxel; one that has come beyond the bounds ends.
bool walk_within(const Ray ray, inout Walk walk, uint root, const Bounds bounds) {
  bool found = false;
  int place = -1;
  while (place < 0) {
    found = (is_in_volume(walk.cell) || walk.open >= 0) && walk_on(ray, walk, root);
    place = found ? place_of_entry(ray, walk, bounds) : 0;
    if (place < 0)
      step_over_voxel(ray, walk);
  }
  if (found && place == 1)
    walk.cell = ivec3(-1);
  if (!SETTLES && found && place == UNTOLD)
    walk.open = AGAIN;
  return found && place == 0;
}
