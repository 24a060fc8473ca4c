// Rays that begin far away, whose numbers would be too wrong to tell anything of a volume: they are moved along themselves until they
// begin near it.
//
// A ray is moved by a moment of which 12 bits are set, so that the moment times the upper 12 bits of a component of the direction is a
// float32, and times the lower 12 bits too: no product is rounded. What is summed up is kept as two float32, `high` and `low`, of
// which the lower one is wrong by a few of its own roundings. A ray that comes to the volume after a moment M, D < 2 M voxels long, begins at
// most the volume's size and D away from it, so that a move loses less than 2^-43 (2 D + far_away()), whichever way sums are rounded.
// It ends before the volume, at 2^-11 of the distance.
//
// A move keeps where the ray goes, so that nothing that is exact is touched: only what float32 says of it.

// The distance in voxels beyond which a ray is far.
float far_away() {
  int side = max(max(VOLUME_SIZE.x, VOLUME_SIZE.y), VOLUME_SIZE.z);
  // In doubles, of a component that was raised to LEAST_COMPONENT, a t that is not larger makes less than one rounding.
  return float(DOUBLES ? max(2 * side, 131072) : 2 * side);
}

// What is known of a ray that may have been moved.
struct Start {
  bool is_far;   // It still begins far away, and float32 tells nothing of it.
  float wrong;   // What may be wrong of its coordinates, beside a few roundings,
  float t_error; // and of a t.
};

bool is_far(real3 coordinate, bvec3 moves) {
  return any(greaterThan(abs(vec3(coordinate)), mix(vec3(NEVER), vec3(far_away()), moves)));
}

// Moves coordinates. Those in float32 are sums of two: what the first sum loses is added to the second. Doubles lose one rounding of
// 2^-53.
void move_by(real3 way, inout real3 high, inout real3 low) {
  if (DOUBLES) {
    high += way;
    return;
  }
  precise real3 sum = high + way;
  precise real3 of_way = sum - high;
  precise real3 of_high = sum - of_way;
  precise real3 lost = (high - of_high) + (way - of_way);
  high = sum;
  low += lost;
}

// Moves a ray that begins far away, to before the last of the faces by which it enters the volume. Once is enough up to a thousand
// times that distance.
Start come_near(inout Ray ray, real3 face) {
  const uint UPPER = 0xfffff000u; // The bits of a float32 but the lowest 12 of its significand.
  const int MOST_MOVES = 3;
  Start start = Start((COMES_NEAR || EXACT_FALLBACK) && is_far(ray.origin, ray.moves), 0.0f,
                      0.0f); // No ordinary ray is, if none comes near.
  if (!COMES_NEAR || !start.is_far)
    return start;
  vec3 direction = mix(vec3(0.0f), vec3(ray.direction), ray.moves);
  const float LAST = 18446744073709551616.0f; // 2^64, at least as many voxels away.
  vec3 upper = uintBitsToFloat(floatBitsToUint(direction) & UPPER);
  real3 high = ray.origin, low = real3(0.0f);
  float latest = 0.0f;
  for (int moves = 0; moves < MOST_MOVES && start.is_far; moves++) {
    vec3 t = mix(vec3(-NEVER), vec3((face - high) * ray.inverse), ray.moves);
    latest = max(max(t.x, t.y), t.z);
    bool is_ahead = latest > 0.0f && latest < LAST;
    float moment = is_ahead ? uintBitsToFloat(floatBitsToUint(latest * (1.0f - 1.0f / 1048576.0f)) & UPPER) : 0.0f;
    start.wrong += (4.0f * moment + far_away()) / 8796093022208.0f; // 2^43.
    move_by(real3(moment * upper), high, low);
    move_by(real3(moment * (direction - upper)), high, low);
    latest -= moment;
    start.is_far = is_far(high, ray.moves);
  }
  precise real3 whole = high + low;
  precise real3 behind = low - (whole - high);
  ray.origin = start.is_far ? ray.origin : whole;
  ray.late = start.is_far ? ray.late : mix(real3(0.0f), behind * ray.inverse, ray.moves);
  real3 steep = abs(ray.inverse);
  // A t is rounded once more by what comes late, and none in the volume is above that of its last entry and the longest side, which is half of what is far.
  steep = mix(real3(0.0f), steep, ray.moves);
  start.t_error =
      2.0f * start.wrong * float(max(max(steep.x, steep.y), steep.z)) + (latest + 0.5f * far_away()) * float(ROUNDINGS) / 4.0f;
  start.wrong += DOUBLES ? 0.0f : far_away() / 4194304.0f; // What is behind, and that rounding.
  return start;
}
