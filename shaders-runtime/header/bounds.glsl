// What lies between two moments of a ray, tmin and tmax.

// The bits of a moment, for which one before 0 is as good as 0.
uint moment_of(float t) {
  uint bits = floatBitsToUint(t);
  return bits > SIGN_BIT && bits <= (SIGN_BIT | INFINITY_BITS) ? 0u : bits & ~SIGN_BIT;
}

// True if a voxel can be entered between two moments: neither is a NaN, and no voxel is entered at +inf.
bool is_interval(uint tmin, float tmax) {
  uint bits = floatBitsToUint(tmax);
  return tmin < INFINITY_BITS && (bits == SIGN_BIT ? tmin == 0u : bits <= INFINITY_BITS && tmin <= bits);
}

// Whether the ray enters the walk's cell before a moment, -1, at it, 0, or after it, 1. Exact.
int compare_entry(const Ray ray, const Walk walk, uint moment) {
  if (walk.axis < 0)
    return moment == 0u ? 0 : -1;
  // (face - origin) * 1 - moment * direction.
  uint one = floatBitsToUint(1.0f);
  uint face = floatBitsToUint(float(entered_face(ray, walk)));
  uint origin = ray.given_origin[walk.axis];
  uint direction = ray.given_direction[walk.axis];
  int order = sign_of(sum_of_products(uvec4(face, origin ^ SIGN_BIT, moment ^ SIGN_BIT, 0u), uvec4(one, one, direction, 0u)));
  return ray.falls[walk.axis] ? -order : order;
}

// Moves a walk that begins long before a moment to a cell that the ray comes to shortly before.
void skip_to(const Ray ray, inout Walk walk, uint moment) {
  const int WORTH_SKIPPING = 4; // In voxels.
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

// Goes on from the walk's voxel to the next one on the ray.
bool walk_past(const Ray ray, inout Walk walk, uint root) {
  step_over_voxel(ray, walk);
%if exact
  while (walk.open >= 0)
    settle_step(ray, walk);
%end
  return is_in_volume(walk.cell) && walk_on(ray, walk, root);
}

// Walks to the first voxel that the ray enters at a moment or later, if it does so at another or before.
bool walk_within(const Ray ray, inout Walk walk, uint root, bool found_first, uint tmin, uint tmax) {
  bool found = found_first;
  while (found && tmin != 0u && compare_entry(ray, walk, tmin) < 0)
    found = walk_past(ray, walk, root);
  return found && (tmax == INFINITY_BITS || compare_entry(ray, walk, tmax) <= 0);
}
