// Puts, for each ray that is not done, the next instances that it may hit before the kernels of their volumes.
// One invocation a ray. The method is that of lib/Trace/Instances/InstanceTree.h, where it is proved.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "world.glsl"

const float NEVER = 3.402823466e38f;
const uint LEAF = 0x80000000u;
const uint NO_CHILD = 0xffffffffu;
const uint MOST_AT_ONCE = 8u;

// A ray of the world, whose direction is scaled by a power of two so that its largest component is in [1/2, 1), and which
// begins anew shortly before what it can hit.
struct BoxRay {
  vec3 origin;
  vec3 inverse; // Of the direction; NEVER with its sign where it is (nearly) 0.
  bvec3 falls;
  float reach;   // What a box's slack is multiplied with.
  float room;    // What a box grows by beside that.
  bool is_tiny;  // Its direction is so small that any box may be hit.
  float tmin, tmax;
};

float largest(vec3 v) { return max(v.x, max(v.y, v.z)); }

BoxRay box_ray(uint at, uint hit) {
  uvec3 bits = direction_of(at);
  vec3 direction = scaled_direction(bits);
  BoxRay ray;
  const float NOTHING = 7.888609052e-31f; // 2^-100.
  for (int axis = 0; axis < 3; ++axis) {
    ray.falls[axis] = bits[axis] >= SIGN_BIT;
    float size = abs(direction[axis]), inverse = size < NOTHING ? NEVER : 1.0f / size;
    ray.inverse[axis] = ray.falls[axis] ? -inverse : inverse;
  }
  dvec3 origin = exact(origin_of(at)), low = world_corner(WORLD_LOW), high = world_corner(WORLD_HIGH);
  float start = start_of(at);
  precise dvec3 begin = origin + dvec3(direction) * double(start);
  ray.origin = vec3(begin);
  vec3 there = vec3(max(abs(low - begin), abs(high - begin))), coordinates = vec3(max(abs(low), abs(high)));
  ray.reach = float(min(distance_to_all(origin), 3.402823466e38lf));
  ray.room = (largest(there) + largest(coordinates)) * (1.0f / 1048576.0f);
  ray.is_tiny = is_tiny(bits);
  uint tmin = RAYS_HAVE_BOUNDS ? ray_words[at + 3u] : 0u;
  ray.tmin = tmin > INFINITY_BITS ? -NEVER : moment_of(tmin, bits, start);
  ray.tmax = moment_of(tmax_left(at, hit), bits, start);
  return ray;
}

// The nearest instances so far, in their order: by moment, then by number.
float moments[MOST_AT_ONCE];
uint numbers[MOST_AT_ONCE];
uint count = 0u;

bool is_before(float moment, uint number, float other_moment, uint other_number) {
  return moment < other_moment || (moment == other_moment && number < other_number);
}

// Beyond this, an instance is of no use.
float limit() { return count == most ? moments[count - 1u] : uintBitsToFloat(INFINITY_BITS); }

void offer(float moment, uint number, float after_moment, uint after_number) {
  if (!is_before(after_moment, after_number, moment, number))
    return;
  if (count == most && !is_before(moment, number, moments[count - 1u], numbers[count - 1u]))
    return;
  uint place = count < most ? count++ : count - 1u;
  for (; place > 0u && is_before(moment, number, moments[place - 1u], numbers[place - 1u]); --place) {
    moments[place] = moments[place - 1u];
    numbers[place] = numbers[place - 1u];
  }
  moments[place] = moment;
  numbers[place] = number;
}

// The moments at which the ray enters and leaves a box; later the former if it misses it.
vec2 moments_of(const BoxRay ray, uint box) {
  precise float slack = uintBitsToFloat(world[box + 24u]) * ray.reach + ray.room;
  precise float near = 0.0f, far = uintBitsToFloat(INFINITY_BITS);
  for (uint axis = 0u; axis < 3u; ++axis) {
    precise float low = uintBitsToFloat(world[box + 4u * axis]) - slack - ray.origin[axis];
    precise float high = uintBitsToFloat(world[box + 12u + 4u * axis]) + slack - ray.origin[axis];
    precise float first = (ray.falls[axis] ? high : low) * ray.inverse[axis];
    precise float last = (ray.falls[axis] ? low : high) * ray.inverse[axis];
    near = max(near, first);
    far = min(far, last);
  }
  return ray.is_tiny ? vec2(0.0f, NEVER) : vec2(near, far);
}

uint waiting[STACK];
float waiting_moments[STACK];

// Finds the nearest instances behind one that was tried before.
void find_nearest(const BoxRay ray, float after_moment, uint after_number) {
  for (uint i = 0u; i < world[EVERYWHERE_COUNT]; ++i)
    offer(0.0f, world[everywhere_at() + i], after_moment, after_number);
  uint depth = 0u;
  if (world[NODE_COUNT] != 0u) {
    waiting[0] = 0u;
    waiting_moments[0] = 0.0f;
    depth = 1u;
  }
  while (depth > 0u) {
    --depth;
    if (waiting_moments[depth] > limit())
      continue;
    uint node = node_at(waiting[depth]);
    uint bottom = depth;
    for (uint lane = 0u; lane < 4u; ++lane) {
      uint child = world[node + 28u + lane];
      if (child == NO_CHILD)
        break;
      vec2 within = moments_of(ray, node + lane);
      float late = within.y + within.y * MOMENT_ROUNDING;
      if (!(within.x <= late) || within.x > limit() || late < ray.tmin ||
          within.x - within.x * MOMENT_ROUNDING > ray.tmax || late < after_moment)
        continue;
      if (child >= LEAF) {
        offer(within.x, child & ~LEAF, after_moment, after_number);
        continue;
      }
      // The nearest comes to lie on top.
      uint place = depth++;
      for (; place > bottom && waiting_moments[place - 1u] < within.x; --place) {
        waiting[place] = waiting[place - 1u];
        waiting_moments[place] = waiting_moments[place - 1u];
      }
      waiting[place] = child;
      waiting_moments[place] = within.x;
    }
  }
}

// False if the device has begun to end loops early (Mesa's llvmpipe does after 65535 turns in all).
bool loops_are_whole() {
  uint wanted = 1u + min(tile_rays, 1u), turns = 0u;
  while (turns < wanted)
    turns++;
  return turns == wanted;
}

double double_at(uint at) { return packDouble2x32(uvec2(world[at], world[at + 1u])); }

// The bits of the nearest float32, of two the even one.
uint nearest_float(double value) {
  uvec2 halves = unpackDouble2x32(value);
  uint sign = halves.y & SIGN_BIT;
  int field = int(halves.y >> 20u & 0x7ffu);
  if (field == 0x7ff)
    return sign | ((halves.y & 0xfffffu) != 0u || halves.x != 0u ? NAN_BITS : INFINITY_BITS);
  int exponent = field - 1023 + 127;
  uint mantissa = (0x100000u | (halves.y & 0xfffffu)) << 3u | halves.x >> 29u; // 24 bits, and the bits behind them:
  uint rest = halves.x << 3u;
  uint bits;
  if (exponent >= 255)
    return sign | INFINITY_BITS;
  if (exponent > 0) {
    bits = uint(exponent) << 23u | (mantissa & 0x7fffffu);
  } else {
    int shift = 1 - exponent;
    if (shift > 25)
      return sign;
    rest = mantissa << (32 - shift) | uint(rest != 0u);
    bits = mantissa >> shift;
  }
  bits += uint(rest > SIGN_BIT || (rest == SIGN_BIT && (bits & 1u) != 0u));
  return sign | bits;
}

// A point, or with 0 in place of 1 a direction, in the voxels of an instance: as lib/Trace/Instances/InstanceRounds.cpp has it.
uvec3 there(uint instance, uvec3 bits, double one) {
  uvec3 result;
  for (uint row = 0u; row < 3u; ++row) {
    uint at = instance + 2u * row;
    precise double x = double_at(at) * exact(bits.x);
    precise double y = double_at(at + 6u) * exact(bits.y);
    precise double z = double_at(at + 12u) * exact(bits.z);
    precise double moved = double_at(at + 18u) * one;
    precise double sum = (x + y) + (z + moved);
    result[row] = nearest_float(sum);
  }
  return result;
}

void put_candidate(uint volume, uint slot, uint number, uint at, uint tmax) {
  bool takes_bounds = words_of_ray(volume) == 8u;
  uint instance = instance_at(number);
  uvec3 origin = there(instance, origin_of(at), 1.0lf), direction = there(instance, direction_of(at), 0.0lf);
  uint to = candidate_ray_at(volume) + words_of_ray(volume) * slot;
  uint direction_to = to + (takes_bounds ? 4u : 3u);
  for (uint axis = 0u; axis < 3u; ++axis) {
    scratch[to + axis] = origin[axis];
    scratch[direction_to + axis] = direction[axis];
  }
  if (takes_bounds) {
    scratch[to + 3u] = RAYS_HAVE_BOUNDS ? ray_words[at + 3u] : 0u;
    scratch[to + 7u] = tmax;
  }
  scratch[candidate_instance_at(volume) + slot] = number;
}

// Puts those that were found before the kernels of their volumes, as far as there is room: of each, the one that was put
// before is the next candidate.
void put_found(uint ray, uint at, uint hit) {
  uvec2 candidate = uvec2(NO_SLOT, 0u);
  uint put = 0u;
  for (; put < count; ++put) {
    uint volume = world[instance_at(numbers[put]) + 24u];
    uint slot = atomicAdd(scratch[starts_of(volume) + 3u], 1u);
    if (slot >= most_rays)
      break;
    put_candidate(volume, slot, numbers[put], at, tmax_left(at, hit));
    scratch[next_candidate_at(volume, slot)] = candidate.x;
    scratch[next_candidate_at(volume, slot) + 1u] = candidate.y;
    candidate = uvec2(slot, volume);
  }
  if (put > 0u) {
    scratch[key_at(ray)] = floatBitsToUint(moments[put - 1u]);
    scratch[key_at(ray) + 1u] = numbers[put - 1u];
  }
  bool more = count == most || put < count;
  scratch[first_candidate_at(ray)] = candidate.x;
  scratch[first_candidate_at(ray) + 1u] = candidate.y | (more ? MORE : 0u);
}

bool is_finite(uvec3 bits) {
  uvec3 size = bits & ~SIGN_BIT;
  return max(size.x, max(size.y, size.z)) < INFINITY_BITS;
}

void begin_ray(uint ray, uint hit) {
  for (uint word = 0u; word < HIT_WORDS; ++word)
    hit_words[hit + word] = word < 3u ? MISS : word == 6u ? NO_INSTANCE : 0u;
  scratch[key_at(ray)] = floatBitsToUint(-1.0f);
  scratch[key_at(ray) + 1u] = 0u;
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= (round == 0u ? tile_rays : scratch[ACTIVE_COUNT]))
    return;
  uint ray = round == 0u ? index : scratch[list_at(round & 1u) + index];
  uint at = ray_at(ray), hit = HIT_WORDS * (first_ray + ray);
  if (round == 0u)
    begin_ray(ray, hit);
  scratch[first_candidate_at(ray)] = NO_SLOT;
  scratch[first_candidate_at(ray) + 1u] = 0u;
  if (!is_finite(origin_of(at)) || !is_finite(direction_of(at)))
    return;
  find_nearest(box_ray(at, hit), uintBitsToFloat(scratch[key_at(ray)]), scratch[key_at(ray) + 1u]);
  if (LOOPS_ARE_CUT && !loops_are_whole()) {
    hit_words[hit] = UNFINISHED;
    return;
  }
  if (count > 0u)
    put_found(ray, at, hit);
}
