// What the kernels of instances have in common: the world's instances, and what is known of each ray between rounds.
// Words of all kinds lie in buffers of uints; lib/Trace/Instances/InstanceLayout.h has the same layouts.

layout(local_size_x = 64) in;

layout(constant_id = 0) const bool RAYS_HAVE_BOUNDS = false; // Those of the host.
layout(constant_id = 1) const bool LOOPS_ARE_CUT = false;    // The device may end loops early.
layout(constant_id = 2) const uint STACK = 100u;             // The most nodes that wait in a traversal.
layout(constant_id = 3) const uint VOLUMES = 1u;

layout(std430, set = 0, binding = 0) readonly restrict buffer Rays { uint ray_words[]; };
layout(std430, set = 0, binding = 1) restrict buffer Hits { uint hit_words[]; };
layout(std430, set = 0, binding = 2) readonly restrict buffer World { uint world[]; };
layout(std430, set = 0, binding = 3) restrict buffer Scratch { uint scratch[]; };

layout(push_constant) uniform Round {
  uint first_ray;  // Of the tile, in the buffers of rays and hits.
  uint tile_rays;  // In the tile.
  uint most_rays;  // That a tile may have: the strides of scratch memory.
  uint round;      // From 0.
  uint most;       // Instances that are tried for a ray in this round.
};

// A hit: voxel, rgba, t, steps or face, instance.
const uint HIT_WORDS = 7u;
const uint NO_INSTANCE = 0xffffffffu;
const uint MISS = 0xffffffffu;       // -1, in place of a voxel.
const uint UNFINISHED = 0xfffffffeu; // -2.

const uint SIGN_BIT = 0x80000000u;
const uint INFINITY_BITS = 0x7f800000u;
const uint NAN_BITS = 0x7fc00000u;

// The world: a header, the words that a ray of each volume's kernel has (8 with bounds, or 6), nodes, numbers of instances
// that any ray may hit, and instances.
const uint NODE_COUNT = 0u;
const uint EVERYWHERE_COUNT = 1u;
const uint LEAST_DIRECTION = 2u;
const uint WORLD_LOW = 3u;
const uint WORLD_HIGH = 6u;
const uint WORLD_SLACK = 9u; // The most of all.
const uint HEADER_WORDS = 16u;
const uint NODE_WORDS = 32u;
const uint INSTANCE_WORDS = 25u; // Three rows of four doubles, column by column, and the volume.

uint words_of_ray(uint volume) { return world[HEADER_WORDS + volume]; }
uint node_at(uint number) { return HEADER_WORDS + VOLUMES + NODE_WORDS * number; }
uint everywhere_at() { return node_at(world[NODE_COUNT]); }
uint instance_at(uint number) { return everywhere_at() + world[EVERYWHERE_COUNT] + INSTANCE_WORDS * number; }

// Scratch memory. Counts first; then, of each ray of the tile, the last instance that was tried, and its first candidate; two
// lists of rays that are not done, which take turns; and of each volume candidates: rays, hits, instances, the next candidates
// of their rays, and the list of its kernel.
const uint ACTIVE_GROUPS = 0u; // With which the next dispatch over the list is started.
const uint ACTIVE_COUNT = 3u;
const uint NEXT_COUNT = 4u;
const uint VOLUME_STARTS = 16u; // Of each volume: groups in three words, and the number of rays.

uint starts_of(uint volume) { return VOLUME_STARTS + 4u * volume; }
uint rounded_up(uint words) { return (words + 63u) & ~63u; }
uint rays_at() { return rounded_up(VOLUME_STARTS + 4u * VOLUMES); }
uint key_at(uint ray) { return rays_at() + 2u * ray; }
uint first_candidate_at(uint ray) { return rays_at() + 2u * most_rays + 2u * ray; }
uint list_at(uint which) { return rays_at() + (4u + which) * most_rays; }
uint volume_at(uint volume) { return rays_at() + 6u * most_rays + volume * (18u * most_rays + 64u); }
uint candidate_ray_at(uint volume) { return volume_at(volume); }
uint candidate_hit_at(uint volume) { return volume_at(volume) + 8u * most_rays; }
uint candidate_instance_at(uint volume) { return volume_at(volume) + 14u * most_rays; }
uint next_candidate_at(uint volume, uint slot) { return volume_at(volume) + 15u * most_rays + 2u * slot; }

// A candidate is a slot of a volume: two words. Of a ray's first one, the second word also says whether there may be more
// instances than are candidates.
const uint NO_SLOT = 0xffffffffu;
const uint MORE = 0x80000000u;

// Moments by float32 are off by less than this, of them.
const float MOMENT_ROUNDING = 1.0f / 1048576.0f;

// The magnitude of float32 bits times 2^exponent: 0 and infinity where that is no normal number. Devices may take denormal
// numbers for 0; this does not.
float scaled(uint bits, int exponent) {
  uint magnitude = bits & ~SIGN_BIT;
  if (magnitude >= INFINITY_BITS)
    return uintBitsToFloat(INFINITY_BITS);
  if (magnitude == 0u)
    return 0.0f;
  int field = int(magnitude >> 23u);
  if (field == 0) {
    int shift = 23 - findMSB(magnitude);
    magnitude <<= shift;
    field = 1 - shift;
  }
  field += exponent;
  uint result = field >= 255 ? INFINITY_BITS : field <= 0 ? 0u : uint(field) << 23u | (magnitude & 0x7fffffu);
  return uintBitsToFloat(result);
}

// The exponent that brings a magnitude into [1/2, 1); 0 for 0.
int exponent_of(uint magnitude) {
  if (magnitude == 0u)
    return 0;
  int field = int(magnitude >> 23u);
  return (field == 0 ? findMSB(magnitude) - 22 : field) - 126;
}

uint ray_at(uint ray) { return (RAYS_HAVE_BOUNDS ? 8u : 6u) * (first_ray + ray); }
uvec3 origin_of(uint at) { return uvec3(ray_words[at], ray_words[at + 1u], ray_words[at + 2u]); }
uvec3 direction_of(uint at) {
  uint first = at + (RAYS_HAVE_BOUNDS ? 4u : 3u);
  return uvec3(ray_words[first], ray_words[first + 1u], ray_words[first + 2u]);
}

int exponent_of_direction(uvec3 direction) {
  uvec3 size = direction & ~SIGN_BIT;
  return exponent_of(max(size.x, max(size.y, size.z)));
}

// The number of float32 bits; of a denormal one too, which a device may take for 0.
double exact(uint bits) {
  uint magnitude = bits & ~SIGN_BIT;
  if (magnitude >= 0x800000u)
    return double(uintBitsToFloat(bits));
  double small = double(magnitude) * packDouble2x32(uvec2(0u, 0x36a00000u)); // 2^-149.
  return bits >= SIGN_BIT ? -small : small;
}

dvec3 exact(uvec3 bits) { return dvec3(exact(bits.x), exact(bits.y), exact(bits.z)); }

dvec3 world_corner(uint at) {
  return dvec3(uintBitsToFloat(world[at]), uintBitsToFloat(world[at + 1u]), uintBitsToFloat(world[at + 2u]));
}

// The direction, scaled so that its largest component is in [1/2, 1).
vec3 scaled_direction(uvec3 direction) {
  int exponent = exponent_of_direction(direction);
  vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    float size = scaled(direction[axis], -exponent);
    result[axis] = direction[axis] >= SIGN_BIT ? -size : size;
  }
  return result;
}

// So small that any box may be hit.
bool is_tiny(uvec3 direction) {
  uvec3 size = direction & ~SIGN_BIT;
  uint longest = max(size.x, max(size.y, size.z));
  return longest != 0u && longest < world[LEAST_DIRECTION];
}

// From the ray's origin to the farthest corner of all boxes, and a little more.
double distance_to_all(dvec3 origin) {
  dvec3 low = world_corner(WORLD_LOW), high = world_corner(WORLD_HIGH);
  return length(max(abs(low - origin), abs(high - origin))) * (1.0lf + 1.0lf / 1048576.0lf);
}

// A moment of the scaled ray shortly before it comes to what it can hit: `startOf` of lib/Trace/Instances/InstanceTree.cpp.
float start_of(uint at) {
  uvec3 bits = direction_of(at);
  dvec3 origin = exact(origin_of(at)), direction = dvec3(scaled_direction(bits));
  double square = dot(direction, direction);
  if (world[EVERYWHERE_COUNT] != 0u || is_tiny(bits) || !(square > 0.0lf))
    return 0.0f;
  dvec3 low = world_corner(WORLD_LOW), high = world_corner(WORLD_HIGH);
  double reach = distance_to_all(origin) * double(uintBitsToFloat(world[WORLD_SLACK]));
  double radius = length(high - low) * 0.5lf + 2.0lf * reach;
  double middle = dot((low + high) * 0.5lf - origin, direction) / square;
  const double BACK = 1.0lf / 262144.0lf; // 2^-18.
  double start = middle - abs(middle) * BACK - radius * (1.0lf + BACK) / sqrt(square);
  return float(clamp(start, 0.0lf, 3.402823466e38lf));
}

// A moment of the ray as one of the scaled ray behind its start. Infinity stays.
float moment_of(uint t, uvec3 direction, float start) {
  if (t >= INFINITY_BITS)
    return uintBitsToFloat(INFINITY_BITS);
  float moment = scaled(t, exponent_of_direction(direction));
  return isinf(moment) ? moment : float(double(moment) - double(start));
}

// The bits of tmax, of which infinity is the most, with what was hit so far: a voxel that is entered a little later may have
// the same t, rounded. NaN stays: nothing lies before it.
uint tmax_left(uint at, uint hit) {
  uint tmax = RAYS_HAVE_BOUNDS ? ray_words[at + 7u] : INFINITY_BITS;
  if (hit_words[hit + 6u] == NO_INSTANCE || tmax > INFINITY_BITS)
    return tmax;
  return min(tmax, min(hit_words[hit + 4u] + 1u, INFINITY_BITS));
}
