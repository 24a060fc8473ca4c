#version 460
// intersect.glsl: first hits of rays with volumes of the format D(5, 5, 5, 15) M(2, 2, 2) M(2, 2, 2).

// Voxels along each axis.
const ivec3 VOLUME_SIZE = ivec3(512, 512, 512);

// Before a function that is seldom called: kernels in C++ keep it out of the loops, into which all others go.
#define OUT_OF_LINE

layout(local_size_x = 64) in;

// Count the lookups of each ray; off, it costs nothing.
layout(constant_id = 0) const bool COUNT_LOOKUPS = false;
// Count the words that each ray reads, and store that in place of its lookups; off, it costs nothing.
layout(constant_id = 2) const bool COUNT_WORDS = false;
uint words_read = 0u;

// Six words a ray, the bits of float32: origin, direction.
layout(std430, set = 0, binding = 0) readonly restrict buffer Rays { uint ray_words[]; };
// Six words a hit: voxel, rgba, t, lookups or words read.
layout(std430, set = 0, binding = 1) restrict buffer Hits { uint hit_words[]; };
// A dispatch that does not settle leaves the rays which exact arithmetic has to look at to one that does, over these alone:
// what that is started with, how many they are, and their numbers.
layout(std430, set = 0, binding = 3) restrict buffer Left { uint left_groups[3]; uint left_count; uint left_rays[]; };
layout(constant_id = 3) const bool SETTLES = true;
// The rays of this dispatch; a `task` other than all of them, from their beginning, goes on with rays that were left.
layout(push_constant) uniform Tile { uint first_ray; uint ray_count; uint task; };
const uint ALL = 0u;
const uint LEFT_OVER = 1u; // Those of the list.
const uint CUT_OFF = 2u; // Those that are unfinished.

// The volume's words lie in one storage buffer.
layout(std430, set = 0, binding = 2) readonly restrict buffer Words { uint words[]; };

uint load_word(uint offset) {
  if (COUNT_WORDS)
    words_read++;
  return words[offset];
}

// A ray, prepared for walking. Its members that are no integers are approximate; what must be exact is asked of the ray as given.
struct Ray {
  uvec3 given_origin;    // The bits of six float32 taken as exact numbers.
  uvec3 given_direction;
  vec3  origin;          // Where walking counts from: the given origin, or where a ray from far away enters.
  vec3  direction;       // Scaled by a power of two: the largest component is in [1, 2), and none so small that
  vec3  inverse;         // its inverse overflows. All t are those of this direction, from this origin.
  float slack;           // What is wrong of a t, beside a few roundings.
  vec3  lowest;          // The least that is certain of the coordinates at the origin,
  vec3  doubt;           // and how much more any coordinate on the way may be, in voxels.
  float certain;         // A coordinate that is at least this far below the next whole number is in its cell.
  bvec3 moves;           // False on an axis whose coordinate never changes.
  bvec3 falls;           // The coordinate falls.
  bool plain;            // As given, it has no numbers but 0 and those whose significand has all its bits.
  ivec3 heading;         // 1, -1 or 0.
  vec3  beyond;          // From a face that the ray passes to the cell behind it: -1 where the coordinate falls, else 0.
  ivec3 ahead;           // All bits where the coordinate rises, else none: picks the face of a cube that lies ahead.
};

// Empty cubes of 2^log2_side voxels a side: the one around a cell and, `count` a side, those that lie ahead of it.
struct Gap {
  int log2_side;
  int count;
};

// How a ray leaves cells through the faces ahead.
struct Exit {
  float t;       // About when.
  bvec3 passed;  // The axes whose faces it passes.
  bool sure;     // It is known to pass that one first.
};

// Where a ray is: the first cell not yet proved empty. Each step moves it by at least one cell, and never back.
struct Walk {
  ivec3 cell; // In voxels; outside the volume before and after the walk.
  int axis;   // The axis on which the ray entered the cell; -1 where it started.
  uint voxel; // Where the voxel that was hit is to be had, as the lowest level finds it.
  uint lookups;
  int steps_left; // There are no more cells on any ray; a walk with less than 0 is an error of the kernel's.
  int open; // The step over a gap around ~cell is left to be settled: 32 times its count, and its log2_side. Else CLOSED.
};

const int CLOSED = -1;
const int AGAIN = -2; // The walk is to be gone on with, from its cell, by who settles.

const float NEVER = 1e30f; // A t, and so a distance for a coordinate that never changes.

// Twelve roundings of 2^-23, whichever way each goes. A t is a difference, an inverse (2.5 roundings) and a product; the
// order of two t is certain beyond 11 roundings of the earlier, and a coordinate within 9.5 of how far it may be from the
// origin.
const float ROUNDINGS = 12.0f / 8388608.0f;

// A walk that is about to begin, or to go on.
Walk walk_at(ivec3 cell) {
  return Walk(cell, -1, 0u, 0u, VOLUME_SIZE.x + VOLUME_SIZE.y + VOLUME_SIZE.z, CLOSED);
}

// Ends a walk that takes more steps than any can.
void count_step(inout Walk walk) {
  walk.steps_left--;
  walk.cell.x |= walk.steps_left >> 31; // All bits: outside, whatever follows.
}

void count_lookup(inout Walk walk) {
  if (COUNT_LOOKUPS)
    walk.lookups++;
}

bool is_in_volume(ivec3 cell) { return all(lessThan(uvec3(cell), uvec3(VOLUME_SIZE))); }

// Whether a walk has more to see here.
bool goes_on(const Walk walk) {
  return is_in_volume(walk.cell);
}

// True if two cells lie in one aligned cube of 2^log2_side voxels a side.
bool is_same_cube(ivec3 a, ivec3 b, int log2_side) {
  ivec3 differ = a ^ b;
  return (differ.x | differ.y | differ.z) >> log2_side == 0;
}

// The low corner of the aligned cube of 2^log2_side voxels a side around a cell.
ivec3 corner_of(ivec3 cell, int log2_side) { return (cell >> log2_side) << log2_side; }

float min_of(vec3 v) { return min(min(v.x, v.y), v.z); }

// The number of the ray's octant: a bit for each coordinate that rises, that of x lowest.
int octant_of(const Ray ray) { return (ray.ahead.x & 1) | (ray.ahead.y & 2) | (ray.ahead.z & 4); }

// The low corner of the cube of a gap around a cell.
ivec3 corner_of(const Ray ray, ivec3 cell, const Gap gap) {
  return corner_of(cell, gap.log2_side) - (~ray.ahead & ((gap.count - 1) << gap.log2_side));
}

// The faces of a gap around a cell that lie ahead.
ivec3 faces_ahead(const Ray ray, ivec3 cell, const Gap gap) {
  int side = 1 << gap.log2_side;
  int back = side - (gap.count << gap.log2_side); // From the cube's low face to that of the gap, where the coordinate falls.
  return (cell & -side) + back + (ray.ahead & (side - back - back));
}

// About when each coordinate passes its face.
vec3 times_of(const Ray ray, ivec3 face) { return (vec3(face) - ray.origin) * ray.inverse; }

// Float32 numbers as integers: significand * 2^(exponent - 150). No device flushes or rounds these.

const uint SIGN_BIT = 0x80000000u;
const uint INFINITY_BITS = 0x7f800000u;

// Below 2^24.
uint significand_of(uint bits) {
  uint fraction = bits & 0x7fffffu;
  return (bits & INFINITY_BITS) == 0u ? fraction : fraction | 0x800000u;
}

int exponent_of(uint bits) { return max(int(bits >> 23 & 0xffu), 1); }

bool are_finite(uvec3 bits) { return all(lessThan(bits & INFINITY_BITS, uvec3(INFINITY_BITS))); }

// True if each is 0 or has a significand of 24 bits, as devices do not always keep smaller ones.
bool are_plain(uvec3 bits) { return all(greaterThanEqual((bits & ~SIGN_BIT) - 1u, uvec3(0x7fffffu))); }

// 2^exponent, for exponents of normal numbers; the nearest such for others.
float power_of_two(int exponent) { return uintBitsToFloat(uint(clamp(exponent, -126, 127) + 127) << 23); }

// The largest whole numbers that are not above float32 numbers, within 2^22 of zero.
ivec3 floor_of(uvec3 bits) {
  ivec3 whole = ivec3(clamp(floor(uintBitsToFloat(bits)), -4194304.0f, 4194304.0f));
  // Below 1, a denormal number may not survive arithmetic.
  ivec3 small = -ivec3(greaterThan(bits, uvec3(SIGN_BIT)));
  return mix(whole, small, lessThan(bits & ~SIGN_BIT, uvec3(0x3f800000u)));
}

// The exact sign of a sum of four products of float32 numbers.

// A sum in two's complement, times 2^(exponent - 300). Its sign is exact, its value within 2^-11 of itself.
struct Sum {
  int high;
  uint low;
  int exponent;
  bool complete; // Unless the device cut the work short.
};

int sign_of(const Sum sum) { return sum.high < 0 ? -1 : (uint(sum.high) | sum.low) != 0u ? 1 : 0; }

// The largest p for which 2^p is not above the magnitude; -1 for 0, and for -1 too.
int log2_of(const Sum sum) {
  uint flip = uint(sum.high >> 31);
  uint high = uint(sum.high) ^ flip;
  return findMSB(high != 0u ? high : sum.low ^ flip) + (high != 0u ? 32 : 0);
}

// Makes `shift` bits, at most 61, of room at the low end.
void shift_left(inout Sum sum, int shift) {
  uint high = uint(sum.high);
  if (shift >= 32) {
    high = sum.low << (shift - 32);
    sum.low = 0u;
  } else if (shift > 0) {
    high = high << shift | sum.low >> (32 - shift);
    sum.low <<= shift;
  }
  sum.high = int(high);
  sum.exponent -= shift;
}

void add(inout Sum sum, uint high, uint low, bool negative) {
  uint flip = negative ? ~0u : 0u;
  uint carry_of_low, carry_of_sign;
  uint partial = uaddCarry(sum.low, low ^ flip, carry_of_low);
  sum.low = uaddCarry(partial, flip & 1u, carry_of_sign);
  sum.high = int(uint(sum.high) + (high ^ flip) + carry_of_low + carry_of_sign);
}

// a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w, of bits of float32. A product is below 2^48 times its power of two.
// They are added from the largest power down; once the sum has 61 bits at the next power, all that is left is too small
// to change its sign.
OUT_OF_LINE Sum sum_of_products(uvec4 a, uvec4 b) {
  ivec4 exponent = ivec4(exponent_of(a.x) + exponent_of(b.x), exponent_of(a.y) + exponent_of(b.y),
                         exponent_of(a.z) + exponent_of(b.z), exponent_of(a.w) + exponent_of(b.w));
  Sum sum = Sum(0, 0u, 0, false);
  int left = 4;
  while (left > 0) {
    int largest = max(max(exponent.x, exponent.y), max(exponent.z, exponent.w));
    int next = exponent.x == largest ? 0 : exponent.y == largest ? 1 : exponent.z == largest ? 2 : 3;
    uint high, low;
    umulExtended(significand_of(a[next]), significand_of(b[next]), high, low);
    if (sign_of(sum) == 0)
      sum.exponent = largest;
    int shift = sum.exponent - largest;
    exponent[next] = -1;
    left--;
    if (log2_of(sum) + shift >= 61) {
      left = 0;
    } else {
      shift_left(sum, shift);
      add(sum, high, low, (a[next] ^ b[next]) >= SIGN_BIT);
    }
  }
  sum.complete = left == 0;
  return sum;
}

// sum / divisor in plain float32.
float quotient(const Sum sum, uint divisor) {
  bool negative = sum.high < 0;
  Sum magnitude = Sum(0, 0u, sum.exponent, true);
  add(magnitude, uint(sum.high), sum.low, negative);
  float value = float(magnitude.high) * 4294967296.0f + float(magnitude.low);
  float size = value / float(significand_of(divisor)) * power_of_two(sum.exponent - exponent_of(divisor) - 150);
  return negative != (divisor >= SIGN_BIT) ? -size : size;
}

// The moments at which a ray changes cell, in exact order. Cells are half-open, so where several coordinates pass a face
// at one t, rising ones change cell first, falling ones just after.

// A change of cell.
struct Crossing {
  float t;     // Approximate.
  int axis;    // One that changes,
  int face;    // and the face that it passes.
  ivec3 step;  // The change, a cell at most on each axis.
  bool rising; // Only rising coordinates change: those that fall may still stand on a boundary.
};

// The change of cell where a ray leaves a cube through the faces ahead: `crossed` tells the axes whose coordinates pass
// them first, about at t.
Crossing crossing_of(const Ray ray, ivec3 face, float t, bvec3 crossed) {
  ivec3 changes = mix(ivec3(0), ray.heading, crossed);
  ivec3 risen = max(changes, ivec3(0));
  Crossing crossing;
  crossing.rising = risen != ivec3(0);
  crossing.step = crossing.rising ? risen : changes;
  crossing.axis = crossing.step.x != 0 ? 0 : crossing.step.y != 0 ? 1 : 2;
  crossing.t = t;
  crossing.face = face[crossing.axis];
  return crossing;
}

// Cells from `least` to `most`.
struct Range {
  ivec3 least;
  ivec3 most;
};

// How far coordinate a is behind at_a when coordinate b passes at_b, with the sign of both speeds:
// (at_a - origin_a) * direction_b - (at_b - origin_b) * direction_a.
Sum crossing_difference(const Ray ray, int a, float at_a, int b, float at_b) {
  uint speed_a = ray.given_direction[a];
  uint speed_b = ray.given_direction[b];
  return sum_of_products(uvec4(floatBitsToUint(at_a), ray.given_origin[a] ^ SIGN_BIT,
                               floatBitsToUint(at_b) ^ SIGN_BIT, ray.given_origin[b]),
                         uvec4(speed_b, speed_b, speed_a, speed_a));
}

const int CUT_SHORT = 2; // No order: the device did not let it be found.


// -1 if coordinate a passes its face first, 0 if both pass theirs at the same t, else 1. Both move.
OUT_OF_LINE int compare_exactly(const Ray ray, int a, int face_a, int b, int face_b) {
  Sum difference = crossing_difference(ray, a, float(face_a), b, float(face_b));
  int order = sign_of(difference);
  order = difference.complete ? order : CUT_SHORT;
  return order == CUT_SHORT || ray.falls[a] == ray.falls[b] ? order : -order;
}

// The same, by doubles where they can tell.
int compare_crossings(const Ray ray, int a, int face_a, int b, int face_b) {
  int order = 0;
  return order != 0 ? order : compare_exactly(ray, a, face_a, b, face_b);
}

int undecided_axis(const Range range) {
  return range.least.x != range.most.x ? 0 : range.least.y != range.most.y ? 1 : 2;
}

int middle_of(const Range range, int axis) {
  return range.least[axis] + (range.most[axis] - range.least[axis] + 1) / 2;
}

// Takes away from a range what lies to one side of a face, where `order` compares it with the crossing.
void narrow(const Ray ray, const Crossing crossing, int axis, int face, int order, inout Range range) {
  bool falls = ray.falls[axis];
  bool passed = order < 0 || (order == 0 && !(falls && crossing.rising));
  if (passed != falls)
    range.least[axis] = face;
  else
    range.most[axis] = face - 1;
}

// Narrows a range down, on each axis, to the cell that the ray is in once a crossing has happened.
OUT_OF_LINE ivec3 settle(const Ray ray, const Crossing crossing, const Range candidates) {
  Range range = candidates;
  while (range.least != range.most) {
    int axis = undecided_axis(range);
    int face = middle_of(range, axis);
    narrow(ray, crossing, axis, face, compare_crossings(ray, axis, face, crossing.axis, crossing.face), range);
  }
  return range.least;
}

// What can be told, without integers, of the cell, within a range, that the ray is in once a crossing has happened.
Range approximate_cell(const Ray ray, const Crossing crossing, const Range range) {
  vec3 point = ray.lowest + crossing.t * ray.direction;
  vec3 least = vec3(range.least);
  vec3 most = vec3(range.most);
  return Range(ivec3(clamp(floor(point), least, most)), ivec3(clamp(floor(point + ray.doubt), least, most)));
}

// Steps that are exact for every ray: float32 where its error bound decides, integers elsewhere.

// How the ray leaves cells through the first of the faces ahead. Not sure if float32 cannot tell which that is.
Exit leave(const Ray ray, vec3 face) {
  vec3 t = (face - ray.origin) * ray.inverse;
  float earlier = min(t.x, t.y);
  float later = max(t.x, t.y);
  float first = min(earlier, t.z);
  float second = max(earlier, min(later, t.z));
  return Exit(first, equal(t, vec3(first)), second > first + (first * ROUNDINGS + ray.slack));
}

// The cell that a ray comes to where it leaves others, of which `cell` is one, by one of the faces ahead. Not sure if float32 cannot tell on
// which side of another face that is.
ivec3 cell_beyond(const Ray ray, ivec3 cell, vec3 face, inout Exit leaving) {
  vec3 point = mix(ray.lowest + leaving.t * ray.direction, face + ray.beyond, leaving.passed);
  vec3 whole = floor(point);
  vec3 rest = point - whole;
  leaving.sure = leaving.sure && max(max(rest.x, rest.y), rest.z) < ray.certain;
  return ivec3(whole);
}

// Settles the step over the gap around the walk's cell: which faces the ray passes first, of
// those that float32 cannot tell apart, and then by bisection to which cell it comes. All questions are asked at one place,
// since devices of wide vectors run through it as often as any ray needs it.
// Where the device cuts it short, the walk stays where it is.
OUT_OF_LINE Walk settled(const Ray ray, Walk walk, const Gap gap) {
  int side = gap.count << gap.log2_side;
  ivec3 corner = corner_of(ray, walk.cell, gap);
  ivec3 face = corner + (ray.ahead & side);
  vec3 t = times_of(ray, face);
  float earliest = min_of(t);
  bvec3 may_be_first = lessThanEqual(t, vec3(earliest + (earliest * ROUNDINGS + ray.slack)));
  ivec3 bits = ivec3(may_be_first) * ivec3(ray.moves);
  int axes = bits.x | bits.y << 1 | bits.z << 2;
  int first = findLSB(uint(axes));
  axes &= axes - 1;
  bvec3 crossed = bvec3(first == 0, first == 1, first == 2);
  Crossing crossing;
  Range range = Range(ivec3(0), ivec3(1));
  bool orders = true;
  int order = 0;
  while (order != CUT_SHORT && range.least != range.most) {
    if (orders && axes == 0) {
      orders = false;
      crossing = crossing_of(ray, face, earliest, crossed);
      ivec3 target = corner + crossing.step * side;
      range = approximate_cell(ray, crossing, Range(target, target + (side - 1)));
    }
    if (orders || range.least != range.most) {
      int axis = orders ? findLSB(uint(axes)) : undecided_axis(range);
      int at = orders ? face[axis] : middle_of(range, axis);
      order = compare_crossings(ray, axis, at, first, face[first]);
      if (!orders) {
        narrow(ray, crossing, axis, at, order, range);
      } else {
        if (order <= 0) {
          bvec3 others = order < 0 ? bvec3(false) : crossed;
          crossed = bvec3(others.x || axis == 0, others.y || axis == 1, others.z || axis == 2);
          first = axis;
        }
        axes &= axes - 1;
      }
    }
  }
  if (order != CUT_SHORT && range.least == range.most) {
    walk.cell = range.least;
    walk.axis = crossing.axis;
  }
  return walk;
}

// Settles the step of a walk that was left open.
void settle_step(const Ray ray, inout Walk walk) {
  Gap gap = Gap(walk.open & 31, walk.open >> 5);
  walk.open = CLOSED;
  walk.cell = ~walk.cell;
  walk = settled(ray, walk, gap);
}

// Steps from one cell of the ray to the next.

// Ends a step over the gap around the walk's cell, or over that and more, which leads to another cell if that is sure.
void end_step(const Ray ray, inout Walk walk, const Exit leaving, ivec3 cell, const Gap gap) {
  walk.axis = leaving.passed.z ? 2 : leaving.passed.y ? 1 : 0;
  bool sure = leaving.sure;
  // A step that is not sure is left open, and the cell is put outside, so that all loops end: what settles it
  // stands outside of them, where lanes that are sure need not wait for it.
  walk.cell = sure ? cell : ~walk.cell;
  walk.open = sure ? CLOSED : gap.count << 5 | gap.log2_side;
  count_step(walk);
}

// Steps over the gap around the walk's cell.
void step_over(const Ray ray, inout Walk walk, const Gap gap) {
  vec3 face = vec3(faces_ahead(ray, walk.cell, gap));
  Exit leaving = leave(ray, face);
  ivec3 cell = cell_beyond(ray, walk.cell, face, leaving);
  end_step(ray, walk, leaving, cell, gap);
}

// Steps over the empty cube of 2^log2_side voxels a side around the walk's cell.
void step_over(const Ray ray, inout Walk walk, int log2_side) { step_over(ray, walk, Gap(log2_side, 1)); }

// Steps from the walk's voxel, which is empty, to the next.
void step_over_voxel(const Ray ray, inout Walk walk) {
  Exit leaving = leave(ray, vec3(walk.cell - ray.ahead));
  end_step(ray, walk, leaving, walk.cell + mix(ivec3(0), ray.heading, leaving.passed), Gap(0, 1));
}

// Where a walk begins: in the cell of the ray's origin, or in the first cell of the volume that the ray comes to.

const float CLOSE = 1.0f / 2048.0f; // In voxels.
const uint TINY_BITS = 0x30800000u; // Of 2^-30.

// Bounds what float32 gets wrong in a walk through the volume, where the origin itself is wrong by `of_origin`, and a t
// by `slack`. A coordinate that never changes stays in its cell, and passes no face.
void bound_errors(inout Ray ray, ivec3 cell, vec3 of_origin, float slack) {
  vec3 reach = max(abs(ray.origin), abs(vec3(VOLUME_SIZE) - ray.origin));
  vec3 error = reach * ROUNDINGS + vec3(of_origin) + slack * abs(ray.direction);
  ray.slack = slack;
  ray.lowest = mix(vec3(cell) + 0.25f, ray.origin - error, ray.moves);
  ray.doubt = mix(vec3(0.0f), 2.0f * error, ray.moves);
  ray.certain = 1.0f - max(max(ray.doubt.x, ray.doubt.y), ray.doubt.z);
  ray.origin = mix(vec3(-NEVER), ray.origin, ray.moves);
}

// True where the ray moves from a coordinate so close to 0 that float32 may lose its distance from there.
bvec3 starts_tiny(const Ray ray) {
  uvec3 size = ray.given_origin & ~SIGN_BIT;
  bvec3 tiny = lessThan(size - 1u, uvec3(TINY_BITS - 1u));
  return greaterThan(ivec3(tiny) * ivec3(ray.moves), ivec3(0));
}

// Of the axes that let the ray into their slab at a face, the last, where a falling one comes after a rising one.
int last_entered(const Ray ray, bvec3 enters, ivec3 face) {
  int last = -1;
  for (int axis = 0; axis < 3; axis++) {
    if (enters[axis]) {
      int order = last < 0 ? 1 : compare_crossings(ray, axis, face[axis], last, face[last]);
      if (order > 0 || (order == 0 && ray.falls[axis]))
        last = axis;
    }
  }
  return last;
}

// The coordinate, kept within a voxel of the volume, that a ray has where it passes a face. Each turn leaves less than
// 2^-10 of the error of the guess before, and what float32 rounds.
float coordinate_at(const Ray ray, int axis, int face, int other) {
  float size = float(VOLUME_SIZE[other]);
  float at = 0.5f * size;
  for (float error = size; error > CLOSE; error *= 1.0f / 1024.0f) {
    float move = quotient(crossing_difference(ray, axis, float(face), other, at), ray.given_direction[axis]);
    at = clamp(at + move, -1.0f, size + 1.0f);
  }
  return at;
}

// Lets a ray from far away start where it passes a face, so that its errors do not grow with its distance.
void start_at(inout Ray ray, ivec3 cell, int axis, int face) {
  vec3 error = vec3(0.0f);
  for (int other = 0; other < 3; other++) {
    if (other == axis) {
      ray.origin[other] = float(face);
    } else if (ray.moves[other]) {
      ray.origin[other] = coordinate_at(ray, axis, face, other);
      error[other] = CLOSE + CLOSE * abs(float(ray.origin[other])) / 256.0f; // More than a few roundings.
    }
  }
  vec3 slack = error * abs(vec3(ray.inverse));
  bound_errors(ray, cell, error, 2.0f * max(max(slack.x, slack.y), slack.z));
}

// Finds the cell in which the ray enters the volume, in exact arithmetic: through the last of the faces that it must pass.
OUT_OF_LINE Walk entered_exactly(inout Ray ray, Walk walk, ivec3 cell, bvec3 enters, ivec3 face, bool starts_far) {
  int axis = last_entered(ray, enters, face);
  if (starts_far)
    start_at(ray, cell, axis, face[axis]);
  Crossing crossing;
  crossing.t = (float(face[axis]) - ray.origin[axis]) * ray.inverse[axis];
  crossing.axis = axis;
  crossing.face = face[axis];
  crossing.rising = !ray.falls[axis];
  Range range = Range(mix(cell, ivec3(-1), ray.moves), mix(cell, VOLUME_SIZE, ray.moves));
  range.least[axis] = range.most[axis] = face[axis] - (ray.falls[axis] ? 1 : 0);
  walk.cell = settle(ray, crossing, approximate_cell(ray, crossing, range));
  walk.axis = axis;
  return walk;
}

// The same by float32. Not sure if that cannot tell which face is the last, or which cell is behind it.
Walk entered(const Ray ray, Walk walk, bvec3 enters, ivec3 face, out bool sure) {
  vec3 t = mix(vec3(-NEVER), times_of(ray, face), enters);
  float latest = max(max(t.x, t.y), t.z);
  bvec3 may_be_last = greaterThanEqual(t, vec3(latest - (latest * ROUNDINGS + ray.slack)));
  ivec3 count = ivec3(may_be_last);
  vec3 point = ray.lowest + latest * ray.direction;
  vec3 whole = floor(point);
  bvec3 certain = lessThan(point - whole, 1.0f - ray.doubt);
  sure = count.x + count.y + count.z == 1 && all(greaterThan(ivec3(certain) + count, ivec3(0)));
  ivec3 behind = face - ivec3(ray.falls);
  walk.cell = mix(ivec3(clamp(whole, -1.0f, 4194304.0f)), behind, may_be_last);
  walk.axis = may_be_last.x ? 0 : may_be_last.y ? 1 : 2;
  return walk;
}

// Puts the walk into the first cell of the volume on the ray; false if there is none.
bool enter_volume(inout Ray ray, inout Walk walk) {
  ivec3 size = VOLUME_SIZE;
  ivec3 cell = floor_of(ray.given_origin);
  ivec3 below = ivec3(lessThan(cell, ivec3(0)));
  ivec3 above = ivec3(greaterThanEqual(cell, size));
  ivec3 enters = (below & ray.ahead) + above * ivec3(ray.falls);
  if (enters != below + above)
    return false;
  float far_away = float(2 * max(max(size.x, size.y), size.z));
  bool starts_far = any(greaterThan(abs(uintBitsToFloat(ray.given_origin)), mix(vec3(NEVER), vec3(far_away), ray.moves)));
  bound_errors(ray, cell, vec3(0.0f), any(starts_tiny(ray)) ? NEVER : 0.0f);
  walk.cell = cell;
  ivec3 face = mix(ivec3(0), size, ray.falls);
  if (enters != ivec3(0)) {
    bvec3 axes = greaterThan(enters, ivec3(0));
    bool sure;
    Walk start = entered(ray, walk, axes, face, sure);
    bool unsure = !sure || starts_far;
    if (!SETTLES && unsure) {
      walk.open = AGAIN;
      walk.cell = ivec3(-1);
      return false;
    }
    if (SETTLES && unsure)
      start = entered_exactly(ray, walk, cell, axes, face, starts_far);
    walk = start;
  }
  return is_in_volume(walk.cell);
}

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
  vec3 scaled;
  for (int axis = 0; axis < 3; axis++) {
    uint significand = significand_of(size[axis]);
    scaled[axis] = float(significand) * power_of_two(-findMSB(significand)) * power_of_two(max(exponent[axis] - largest, -60));
  }
  return scaled;
}

// The same, by float32 where that is exact.
vec3 scaled(uvec3 size, bool plain) {
  uint exponent = max(max(size.x, size.y), size.z) & INFINITY_BITS;
  vec3 scaled = uintBitsToFloat(size) * uintBitsToFloat(0x7f000000u - exponent);
  if (SETTLES && (!plain || exponent == 0x7f000000u))
    scaled = scaled_exactly(size);
  return max(scaled, LEAST_COMPONENT);
}

Ray prepare_ray(uvec3 origin, uvec3 direction) {
  Ray ray;
  uvec3 size = direction & ~SIGN_BIT;
  ray.given_origin = origin;
  ray.given_direction = direction;
  ray.plain = are_plain(origin) && are_plain(direction);
  ray.origin = vec3(uintBitsToFloat(origin));
  ray.moves = notEqual(size, uvec3(0u));
  ray.falls = greaterThan(direction, uvec3(SIGN_BIT));
  vec3 component = scaled(size, ray.plain);
  component = mix(component, -component, ray.falls);
  ray.direction = mix(vec3(0.0f), vec3(component), ray.moves);
  ray.inverse = mix(vec3(1.0f), 1.0f / vec3(component), ray.moves);
  ray.heading = ivec3(ray.moves) - 2 * ivec3(ray.falls);
  ray.ahead = -max(ray.heading, ivec3(0));
  ray.beyond = -vec3(ray.falls);
  return ray;
}

// From a ray to its walk, and the end of the walk.

// A ray that goes nowhere can hit its own cell alone: it is let go anywhere, and takes no later hit.
bool goes_nowhere(uvec3 direction) { return ((direction.x | direction.y | direction.z) & ~SIGN_BIT) == 0u; }

// Makes a ray ready, and its walk too, if that has not begun. False if there is nothing to walk through, or if the ray is left.
bool begin_walk(uvec3 origin, uvec3 direction, uint root, out Ray ray, inout Walk walk) {
  ray = prepare_ray(origin, goes_nowhere(direction) ? uvec3(floatBitsToUint(1.0f), 0u, 0u) : direction);
  if (root == 0u || !are_finite(origin) || !are_finite(direction))
    return false;
  if (!SETTLES && !ray.plain) {
    walk.open = AGAIN;
    return false;
  }
  Walk start = walk;
  bool enters = enter_volume(ray, start);
  if (!enters || (!is_in_volume(walk.cell) && walk.open == CLOSED))
    walk = start;
  return enters;
}

// What becomes of a hit: a ray that goes nowhere loses what is not in its own cell, once its walk has begun.
bool end_walk(uvec3 origin, uvec3 direction, inout Walk walk, bool hit) {
  if (!goes_nowhere(direction) || walk.open == AGAIN || walk.cell == floor_of(origin))
    return hit;
  walk.cell = ivec3(-1);
  walk.open = CLOSED;
  return false;
}

// The t of a face, correctly rounded, in integers.

// An unsigned number of 64 bits.
struct Wide {
  uint high;
  uint low;
};

bool is_below(const Wide a, const Wide b) { return a.high < b.high || (a.high == b.high && a.low < b.low); }

Wide sum_of(const Wide a, const Wide b) {
  uint carry;
  uint low = uaddCarry(a.low, b.low, carry);
  return Wide(a.high + b.high + carry, low);
}

Wide difference_of(const Wide a, const Wide b) {
  uint borrow;
  uint low = usubBorrow(a.low, b.low, borrow);
  return Wide(a.high - b.high - borrow, low);
}

int log2_of(const Wide number) { return number.high != 0u ? 32 + findMSB(number.high) : findMSB(number.low); }

// number * 2^shift, shift in [-63, 63]. Bits that fall off the low end are told of; none falls off the high end.
Wide shifted(const Wide number, int shift, inout bool inexact) {
  int right = max(-shift, 0);
  int left = max(shift, 0);
  uint high = number.high;
  uint low = number.low;
  if (right >= 32) {
    inexact = inexact || low != 0u;
    low = high;
    high = 0u;
    right -= 32;
  } else if (left >= 32) {
    high = low;
    low = 0u;
    left -= 32;
  }
  if (right > 0) {
    inexact = inexact || (low & ((1u << right) - 1u)) != 0u;
    low = low >> right | high << (32 - right);
    high >>= right;
  } else if (left > 0) {
    high = high << left | low >> (32 - left);
    low <<= left;
  }
  return Wide(high, low);
}

// A number of 50 bits, times 2^exponent.
struct Distance {
  Wide number;
  int exponent;
  bool inexact; // The exact distance is a little more.
};

// |face - origin|, its leading 50 bits.
Distance distance_to(uint face, uint origin) {
  uint significand = significand_of(origin);
  int exponent = exponent_of(origin) - 150;
  // The larger of the two has its first bit at place 61, and so none below place 0.
  int top = max(face == 0u ? -1000 : findMSB(face), significand == 0u ? -1000 : exponent + findMSB(significand));
  Distance distance = Distance(Wide(0u, 0u), 0, false);
  Wide a = shifted(Wide(0u, face), clamp(61 - top, -63, 63), distance.inexact);
  Wide b = shifted(Wide(0u, significand), clamp(61 - top + exponent, -63, 63), distance.inexact);
  if (origin >= SIGN_BIT) {
    a = sum_of(a, b);
  } else {
    a = is_below(a, b) ? difference_of(b, a) : difference_of(a, b);
    if (distance.inexact) // What fell off was to be taken away.
      a = difference_of(a, Wide(0u, 1u));
  }
  int place = log2_of(a) - 49;
  distance.number = shifted(a, -place, distance.inexact);
  distance.exponent = top - 61 + place;
  return distance;
}

// value * 2^exponent of a value below 2^27, rounded to the nearest float32, ties to even; `inexact` if it is a little more.
uint rounded(uint value, int exponent, bool inexact) {
  int log2_value = findMSB(value) + exponent;
  if (log2_value > 127)
    return INFINITY_BITS;
  int drop = min(findMSB(value) - 23 + max(-126 - log2_value, 0), 31);
  uint kept = value >> drop;
  uint rest = value & ((1u << drop) - 1u);
  uint middle = 1u << (drop - 1);
  if (rest > middle || (rest == middle && (inexact || (kept & 1u) != 0u)))
    kept++;
  return min((uint(max(log2_value + 126, 0)) << 23) + kept, INFINITY_BITS);
}

// When the ray passes a face ahead of its origin: |face - origin| / |direction|, as bits of float32.
OUT_OF_LINE uint time_exactly(const Ray ray, int axis, int face) {
  Distance distance = distance_to(uint(face), ray.given_origin[axis]);
  if (distance.number.high == 0u)
    return 0u;
  uint divisor = significand_of(ray.given_direction[axis]);
  int shift = 23 - findMSB(divisor);
  divisor <<= shift;
  // The quotient, below 2^27, by an estimate that an exact remainder corrects: what float32 rounds leaves it wrong by less
  // than 100, so the remainder fits 32 bits; the quotient of that is wrong by 1 at most.
  float size = float(divisor);
  float estimate = (float(distance.number.high) * 4294967296.0f + float(distance.number.low)) / size;
  uint value = uint(estimate);
  uint high, low;
  umulExtended(value, divisor, high, low);
  int rest = int(distance.number.low - low);
  int more = int(floor(float(rest) / size));
  rest -= more * int(divisor);
  int last = rest < 0 ? -1 : rest >= int(divisor) ? 1 : 0;
  value += uint(more + last);
  rest -= last * int(divisor);
  int exponent = distance.exponent - (exponent_of(ray.given_direction[axis]) - 150 - shift);
  return rounded(value, exponent, distance.inexact || rest != 0);
}


// The same, as fast as it can be told.
uint crossing_time(const Ray ray, int axis, int face, out bool sure) {
  sure = false;
  uint bits = 0u;
  if (SETTLES && !sure) {
    bits = time_exactly(ray, axis, face);
    sure = true;
  }
  return bits;
}

// How a ray comes to the voxel that it hits.
struct Arrival {
  uint t; // The bits of a float32.
};

// The face through which the ray entered its cell.
int entered_face(const Ray ray, const Walk walk) {
  return walk.cell[walk.axis] + (ray.falls[walk.axis] ? 1 : 0);
}

// How the ray came to the walk's cell. Not sure where float32 or doubles cannot tell.
Arrival arrival_at(const Ray ray, const Walk walk, bool hit, out bool sure) {
  Arrival arrival;
  arrival.t = 0u;
  sure = true;
  if (!hit || walk.axis < 0)
    return arrival;
  arrival.t = crossing_time(ray, walk.axis, entered_face(ray, walk), sure);
  return arrival;
}

// ---- From here on: D(5, 5, 5, 15) M(2, 2, 2) M(2, 2, 2) ----

// Level 3: masked, 4 x 4 x 4 cells of 1 voxel a side.
const ivec3 LEVEL_3_LOG2_SIZE = ivec3(2, 2, 2);
const int LEVEL_3_LOG2_CELL = 0;
const int LEVEL_3_LOG2_SIDE = 2;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty.
// The value of the cell that is not empty after so many others.
uint value_of_slot_level_3(uint grid, uint slot) {
  return load_word(grid + 2u + slot);
}

// The number of a cell's bit, of which each word of the mask has 32.
int number_level_3(ivec3 cell) { return (cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4; }

// The value of a cell that is not empty.
uint value_level_3(uint grid, ivec3 cell) {
  int number = number_level_3(cell);
  uint low = load_word(grid);
  uint half_mask = number < 32 ? low : load_word(grid + 1u);
  int rank = bitCount(half_mask & ((1u << (number & 31)) - 1u)) + (number < 32 ? 0 : bitCount(low));
  return value_of_slot_level_3(grid, uint(rank));
}

// True if a cell is full. Else the gap is as wide as the aligned group of eight cells around it, if they are all empty, or
// as the grid, if no cell is full that the ray may still come to.
bool is_full_level_3(const Ray ray, uint grid, ivec3 cell, inout Gap gap) {
  int number = number_level_3(cell);
  uint low = load_word(grid);
  uint high = load_word(grid + 1u);
  uint half_mask = number < 32 ? low : high;
  int around = (half_mask >> (number & 10) & 0x00330033u) == 0u ? 1 : 0;
  // The rows, columns and planes from this cell on, a bit for each, and the 64 cells of which these are the sides.
  ivec3 at = cell & 3;
  ivec3 from = at & ray.ahead;
  ivec3 to = at | (ray.ahead & 3);
  uvec3 sides = uvec3((ivec3(2) << to) - (ivec3(1) << from));
  uint plane = sides.x * (sides.y & 1u | (sides.y & 2u) << 3 | (sides.y & 4u) << 6 | (sides.y & 8u) << 9);
  uint low_ahead = plane * (sides.z & 1u | (sides.z & 2u) << 15);
  uint high_ahead = plane * (sides.z >> 2 & 1u | (sides.z & 8u) << 13);
  around = ((low & low_ahead) | (high & high_ahead)) == 0u ? 2 : around;
  gap.log2_side += around;
  return (half_mask >> (number & 31) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
// A voxel's value is looked up once it is hit: here the grid stands for it.
uint cell_level_3(const Ray ray, uint grid, ivec3 cell, inout Gap gap) {
  return is_full_level_3(ray, grid, cell, gap) ? grid : 0u;
}

// The voxel around a cell, from this grid down; 0, and what is empty there, if there is none.
uint locate_level_3(const Ray ray, uint grid, ivec3 cell, inout Gap gap) {
  gap = Gap(LEVEL_3_LOG2_CELL, 1);
  uint value = cell_level_3(ray, grid, cell >> LEVEL_3_LOG2_CELL, gap);
  return value;
}

// Level 2: masked, 4 x 4 x 4 cells of 4 voxels a side.
const ivec3 LEVEL_2_LOG2_SIZE = ivec3(2, 2, 2);
const int LEVEL_2_LOG2_CELL = 2;
const int LEVEL_2_LOG2_SIDE = 4;

// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty.
// The value of the cell that is not empty after so many others.
uint value_of_slot_level_2(uint grid, uint slot) {
  return load_word(grid + 2u + slot);
}

// The number of a cell's bit, of which each word of the mask has 32.
int number_level_2(ivec3 cell) { return (cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4; }

// The value of a cell that is not empty.
uint value_level_2(uint grid, ivec3 cell) {
  int number = number_level_2(cell);
  uint low = load_word(grid);
  uint half_mask = number < 32 ? low : load_word(grid + 1u);
  int rank = bitCount(half_mask & ((1u << (number & 31)) - 1u)) + (number < 32 ? 0 : bitCount(low));
  return value_of_slot_level_2(grid, uint(rank));
}

// True if a cell is full. Else the gap is as wide as the aligned group of eight cells around it, if they are all empty, or
// as the grid, if no cell is full that the ray may still come to.
bool is_full_level_2(const Ray ray, uint grid, ivec3 cell, inout Gap gap) {
  int number = number_level_2(cell);
  uint low = load_word(grid);
  uint high = load_word(grid + 1u);
  uint half_mask = number < 32 ? low : high;
  int around = (half_mask >> (number & 10) & 0x00330033u) == 0u ? 1 : 0;
  // The rows, columns and planes from this cell on, a bit for each, and the 64 cells of which these are the sides.
  ivec3 at = cell & 3;
  ivec3 from = at & ray.ahead;
  ivec3 to = at | (ray.ahead & 3);
  uvec3 sides = uvec3((ivec3(2) << to) - (ivec3(1) << from));
  uint plane = sides.x * (sides.y & 1u | (sides.y & 2u) << 3 | (sides.y & 4u) << 6 | (sides.y & 8u) << 9);
  uint low_ahead = plane * (sides.z & 1u | (sides.z & 2u) << 15);
  uint high_ahead = plane * (sides.z >> 2 & 1u | (sides.z & 8u) << 13);
  around = ((low & low_ahead) | (high & high_ahead)) == 0u ? 2 : around;
  gap.log2_side += around;
  return (half_mask >> (number & 31) & 1u) != 0u;
}

// The same, and the value of a cell that is full; 0 of one that is not.
uint cell_level_2(const Ray ray, uint grid, ivec3 cell, inout Gap gap) {
  return is_full_level_2(ray, grid, cell, gap) ? value_level_2(grid, cell) : 0u;
}

// The voxel around a cell, from this grid down; 0, and what is empty there, if there is none.
uint locate_level_2(const Ray ray, uint grid, ivec3 cell, inout Gap gap) {
  gap = Gap(LEVEL_2_LOG2_CELL, 1);
  uint value = cell_level_2(ray, grid, cell >> LEVEL_2_LOG2_CELL, gap);
  return value == 0u ? 0u : locate_level_3(ray, value, cell, gap);
}

// Level 1: distance, 32 x 32 x 32 cells of 16 voxels a side.
const ivec3 LEVEL_1_LOG2_SIZE = ivec3(5, 5, 5);
const int LEVEL_1_LOG2_CELL = 4;
const int LEVEL_1_LOG2_SIDE = 9;

// A grid has a slot a cell, x fastest, then y, then z: terminating integer.
uint slot_level_1(uint grid, ivec3 cell) {
  ivec3 at = cell;
  return grid + 1u * uint(at.x + ((at.y + (at.z << LEVEL_1_LOG2_SIZE.y)) << LEVEL_1_LOG2_SIZE.x));
}

// The value in a slot, or 0 if its cell is empty: a slot whose lowest field is not 0 holds 4 bits for each octant instead.
uint value_level_1(uint word) { return (word & 15u) != 0u ? 0u : word >> 4; }

// The value of a cell, or 0 if it is empty; `gap` then counts the cells along the largest empty cube ahead.
uint cell_level_1(const Ray ray, uint grid, ivec3 cell, inout Gap gap) {
  uint slot = slot_level_1(grid, cell);
  uint word = load_word(slot);
  uint skip = word;
  gap.count = int(skip >> (octant_of(ray) * 4) & 15u);
  return value_level_1(word);
}

// The voxel around a cell, from this grid down; 0, and what is empty there, if there is none.
uint locate_level_1(const Ray ray, uint grid, ivec3 cell, inout Gap gap) {
  gap = Gap(LEVEL_1_LOG2_CELL, 1);
  uint value = cell_level_1(ray, grid, cell >> LEVEL_1_LOG2_CELL, gap);
  return value == 0u ? 0u : locate_level_2(ray, value, cell, gap);
}

// One loop. Each turn looks at the walk's cell from the root on, through all levels.
bool intersect_level_1(const Ray ray, inout Walk walk, uint root) {
  while (goes_on(walk)) {
    count_lookup(walk);
    Gap gap = Gap(0, 1);
    uint value = locate_level_1(ray, root, walk.cell, gap);
    if (value != 0u) {
      walk.voxel = value;
      return true;
    }
    step_over(ray, walk, gap);
  }
  return false;
}

// What a voxel is: here its value is its colour.
uint colour_of(const Walk walk) { return value_level_3(walk.voxel, walk.cell); }

// ---- To here; what follows is the same in every kernel again ----

// From the buffers to a walk, and back.

uvec3 load_bits(uint at) { return uvec3(ray_words[at], ray_words[at + 1u], ray_words[at + 2u]); }

// The walk of a ray that was left: -2 - cell in place of a voxel, what is open in place of its colour, its axis in place of
// t. One of -1 has not begun.
Walk left_walk(uint at) {
  Walk walk = walk_at(-2 - ivec3(hit_words[at], hit_words[at + 1u], hit_words[at + 2u]));
  walk.axis = int(hit_words[at + 4u]);
  walk.open = max(int(hit_words[at + 3u]), CLOSED);
  walk.cell = walk.open >= 0 ? ~walk.cell : walk.cell;
  bool has_begun = is_in_volume(walk.open >= 0 ? ~walk.cell : walk.cell);
  walk.lookups = words_read = has_begun ? hit_words[at + 5u] : 0u;
  return walk;
}

void store_left(uint at, const Walk walk) {
  ivec3 voxel = -2 - (walk.open >= 0 ? ~walk.cell : walk.cell);
  hit_words[at] = uint(voxel.x);
  hit_words[at + 1u] = uint(voxel.y);
  hit_words[at + 2u] = uint(voxel.z);
  hit_words[at + 3u] = uint(walk.open);
  hit_words[at + 4u] = uint(walk.axis);
  hit_words[at + 5u] = COUNT_WORDS ? words_read : walk.lookups;
}

// A hit is its voxel, if that is asked. A miss is -1. One that would not have ended is told by a cell far below.
void store(uint at, const Walk walk, bool hit, const Arrival arrival) {
  ivec3 voxel = hit ? walk.cell : ivec3(walk.steps_left < 0 ? -0x7fffffff : -1);
  hit_words[at] = uint(voxel.x);
  hit_words[at + 1u] = uint(voxel.y);
  hit_words[at + 2u] = uint(voxel.z);
  hit_words[at + 3u] = hit ? colour_of(walk) : 0u;
  hit_words[at + 4u] = hit ? arrival.t : 0u;
  hit_words[at + 5u] = COUNT_WORDS ? words_read : walk.lookups;
}

// One invocation a ray.

// False if the device has begun to end loops early (Mesa's llvmpipe does after 65535 turns in all). No compiler knows
// ray_count, and so how often this one ought to turn.
bool loops_are_whole() {
  uint wanted = 1u + min(ray_count, 1u);
  uint turns = 0u;
  while (turns < wanted)
    turns++;
  return turns == wanted;
}

// Goes on with a walk to its end, or until it is left.
bool walk_on(const Ray ray, inout Walk walk, uint root) {
  bool hit = false;
  bool goes_on = true;
  while (goes_on) {
    while (SETTLES && walk.open >= 0)
      settle_step(ray, walk);
    // What was settled may have been the last step inside.
    hit = is_in_volume(walk.cell) && intersect_level_1(ray, walk, root);
    goes_on = SETTLES && walk.open >= 0;
  }
  return hit;
}

// Traces a ray, from where it was left if it `goes_on`. True if it is left, again.
bool trace_ray(uint ray_number, bool goes_on) {
  uint at = 6u * ray_number;
  Walk walk = walk_at(ivec3(-1));
  if (goes_on)
    walk = left_walk(at);
  uvec3 direction = load_bits(at + 3u);
  uint root = load_word(0u); // Leads to level 1, unless the volume is empty.
  Ray ray;
  bool hit = begin_walk(load_bits(at), direction, root, ray, walk) && walk_on(ray, walk, root);
  hit = end_walk(load_bits(at), direction, walk, hit);
  bool sure;
  Arrival arrival = arrival_at(ray, walk, hit, sure);
  walk.open = sure ? walk.open : AGAIN;
  // A walk that is still inside the volume without a hit, or whose arrival may not be whole, was cut off by the device.
  if (SETTLES && hit && !loops_are_whole())
    hit = false;
  bool is_left = walk.open != CLOSED || (!hit && is_in_volume(walk.cell));
  if (is_left)
    store_left(at, walk);
  else
    store(at, walk, hit, arrival);
  return is_left;
}

// Puts a ray on the list of those that are left.
void leave(uint ray_number) {
  uint place = atomicAdd(left_count, 1u);
  left_rays[place] = ray_number;
  if ((place & 63u) == 0u)
    atomicAdd(left_groups[0], 1u);
}

void main() {
  uint number = gl_GlobalInvocationID.x;
  if (number >= (task == LEFT_OVER ? left_count : ray_count))
    return;
  uint ray_number = task == LEFT_OVER ? left_rays[number] : first_ray + number;
  if (task == CUT_OFF && int(hit_words[6u * ray_number]) > -2)
    return;
  if (trace_ray(ray_number, task != ALL) && !SETTLES)
    leave(ray_number);
}
