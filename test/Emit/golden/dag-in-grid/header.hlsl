// voxc_r4_4_4_g8_*: rays through volumes of the format R(4, 4, 4) G(8), as functions for HLSL.
//
//     bool voxc_r4_4_4_g8_closest(VOXC_VOLUME volume, float3 origin, float3 direction, float tmin, float tmax, out
// voxc_r4_4_4_g8_Hit hit)
//     bool voxc_r4_4_4_g8_next(VOXC_VOLUME volume, float3 origin, float3 direction, float tmax, inout
// voxc_r4_4_4_g8_Hit hit)
//     bool voxc_r4_4_4_g8_any(VOXC_VOLUME volume, float3 origin, float3 direction, float tmin, float tmax)
//     float3 voxc_r4_4_4_g8_normal(const voxc_r4_4_4_g8_Hit hit)
//     float3 voxc_r4_4_4_g8_outside(float3 origin, float3 direction, const voxc_r4_4_4_g8_Hit hit)
//
// A volume is what you take for one: before you include this, say its type, and how a word of it is loaded.
//
//     ByteAddressBuffer volumes[8];
//     #define VOXC_VOLUME uint
//     #define VOXC_LOAD(volume, index) volumes[volume].Load(4u * (index))
//
// Rays are in voxels; a direction may have any length, and t counts in it. What this text leaves behind has
// names that begin with voxc_r4_4_4_g8_ or VOXC_R4_4_4_G8_, or with make_ before the first of these.
#ifndef VOXC_R4_4_4_G8_HLSL
#define VOXC_R4_4_4_G8_HLSL

// The digest 0xa67ebecd25ab0065 of the format's storage, its low half and its high one. The words of a volume are for
// these
// functions if its digest, which `voxc info` prints, equals this one, and else lead anywhere.
#define VOXC_R4_4_4_G8_STORAGE_DIGEST 0x25ab0065u, 0xa67ebecdu

#if !defined(VOXC_VOLUME) || !defined(VOXC_LOAD)
#error define VOXC_VOLUME as the type of a volume and VOXC_LOAD(volume, index) as a word of one
#endif
#define VOXC_INDEX uint

// Voxels along each axis.
static const int3 voxc_r4_4_4_g8_VOLUME_SIZE = int3(4096, 4096, 4096);

// The choices of GLSL, component by component, that GLSL ES and HLSL lack.

float3 voxc_r4_4_4_g8_mix(float3 a, float3 b, bool3 takes_b) {
  return float3(takes_b.x ? b.x : a.x, takes_b.y ? b.y : a.y, takes_b.z ? b.z : a.z);
}

int3 voxc_r4_4_4_g8_mix(int3 a, int3 b, bool3 takes_b) {
  return int3(takes_b.x ? b.x : a.x, takes_b.y ? b.y : a.y, takes_b.z ? b.z : a.z);
}

// Functions of GLSL on words with carries that other languages lack.

uint voxc_r4_4_4_g8_uaddCarry(uint a, uint b, out uint carry) {
  uint sum = a + b;
  carry = sum < a ? 1u : 0u;
  return sum;
}

uint voxc_r4_4_4_g8_usubBorrow(uint a, uint b, out uint borrow) {
  borrow = a < b ? 1u : 0u;
  return a - b;
}

// By halves of 16 bits.
void voxc_r4_4_4_g8_umulExtended(uint a, uint b, out uint high, out uint low) {
  uint a_low = a & 0xffffu;
  uint a_high = a >> 16;
  uint b_low = b & 0xffffu;
  uint b_high = b >> 16;
  uint lowest = a_low * b_low;
  uint middle = a_high * b_low + (lowest >> 16);
  uint other = a_low * b_high + (middle & 0xffffu);
  high = a_high * b_high + (middle >> 16) + (other >> 16);
  low = other << 16 | lowest & 0xffffu;
}

uint voxc_r4_4_4_g8_load_word(VOXC_VOLUME volume, uint place) { return VOXC_LOAD(volume, place); }

// A ray, prepared for the traversal. Its members that are no integers are approximate; what must be exact is asked of
// the ray as given.
struct voxc_r4_4_4_g8_Ray {
  uint3 given_origin;     // The bits of six float32 taken as exact numbers.
  uint3 given_direction;
  float3 origin;          // Where the traversal counts from: the given origin, or where a ray from far away enters.
  // Scaled so that the longest component is in [1, 2). Where a coordinate never changes it is LEAST_COMPONENT: that
  // passes no face before another does. All t are those of this direction, from this origin.
  float3 direction;
  float3 inverse;
  float3 late;            // By how much each t comes late that is counted from there.
  float t_error;          // Absolute error bound of t, apart from a few rounding errors.
  float3 origin_low;      // The least that is certain of the coordinates at the origin,
  float coordinate_error; // and how much more any coordinate on the way may be, in voxels.
  float cell_margin;      // A coordinate that is at least this far below the next whole number is in its cell.
  bool3 moves;            // False on an axis whose coordinate never changes.
  bool3 falls;            // The coordinate falls.
  bool plain;             // As given, it has no numbers but 0 and those whose significand has all its bits.
  int3 heading;           // -1 where the coordinate falls, else 1.
  // From a face that the ray passes to the cell behind it: -1 where the coordinate falls, else 0.
  float3 beyond;
  int3 ahead;             // No bits where the coordinate falls, else all: picks the face of a cube that lies ahead.
};

// Empty cubes of 2^log2_side voxels a side: the one around a cell and, `count` a side, those that lie ahead of it.
struct voxc_r4_4_4_g8_EmptySpan {
  int log2_side;
  int count;
};

voxc_r4_4_4_g8_EmptySpan make_voxc_r4_4_4_g8_EmptySpan(int log2_side, int count) {
  voxc_r4_4_4_g8_EmptySpan made;
  made.log2_side = log2_side;
  made.count = count;
  return made;
}

// How a ray leaves cells through the faces ahead.
struct voxc_r4_4_4_g8_Exit {
  float t;      // About when.
  bool3 passed; // The axes whose faces it passes.
  bool sure;    // It is known to pass that one first.
};

voxc_r4_4_4_g8_Exit make_voxc_r4_4_4_g8_Exit(float t, bool3 passed, bool sure) {
  voxc_r4_4_4_g8_Exit made;
  made.t = t;
  made.passed = passed;
  made.sure = sure;
  return made;
}

// Where a ray is: the first cell not yet proved empty. Each step moves it by at least one cell, and never back.
struct voxc_r4_4_4_g8_Traversal {
  int3 cell;        // In voxels; outside the volume before and after the traversal.
  int axis;         // The axis on which the ray entered the cell; -1 where it started.
  uint voxel;       // Where the voxel that was hit is to be had, as the lowest level finds it.
  int steps_left;   // There are no more cells on any ray; a traversal with less than 0 is an error of the kernel's.
  // A step over an empty span around ~cell is pending: 32 times its count, and its log2_side. Else NO_PENDING_STEP.
  int pending_step;
  int3 begin;       // A traversal ends where it leaves the box of `size` cells from `begin` on.
  int3 size;
};

voxc_r4_4_4_g8_Traversal make_voxc_r4_4_4_g8_Traversal(int3 cell, int axis, uint voxel, int steps_left,
    int pending_step, int3 begin, int3 size) {
  voxc_r4_4_4_g8_Traversal made;
  made.cell = cell;
  made.axis = axis;
  made.voxel = voxel;
  made.steps_left = steps_left;
  made.pending_step = pending_step;
  made.begin = begin;
  made.size = size;
  return made;
}

static const int voxc_r4_4_4_g8_NO_PENDING_STEP = -1;
// The traversal is to be gone on with, from its cell, by the exact fallback.
static const int voxc_r4_4_4_g8_RETRY = -2;

static const float voxc_r4_4_4_g8_NEVER = 1e30f; // A t that no ray of an ordinary length comes to.

// What is rounded on the way to a t, which is a difference, an inverse and a product. Where devices round to nearest,
// eight roundings: the order of two t is certain beyond 7 roundings of the earlier, and a coordinate within 7 of how
// far it may be from the origin. Else twelve roundings of 2^-23, whichever way each goes: an inverse takes 2.5 of them,
// the order of two t is certain beyond 11, and a coordinate within 9.5.
static const float voxc_r4_4_4_g8_ROUNDINGS = 12.0f / 8388608.0f;

// A traversal that is about to begin, or to go on.
voxc_r4_4_4_g8_Traversal voxc_r4_4_4_g8_traversal_at(int3 cell) {
  int most_steps = voxc_r4_4_4_g8_VOLUME_SIZE.x + voxc_r4_4_4_g8_VOLUME_SIZE.y + voxc_r4_4_4_g8_VOLUME_SIZE.z;
  return make_voxc_r4_4_4_g8_Traversal(cell, -1, 0u, most_steps, voxc_r4_4_4_g8_NO_PENDING_STEP, (int3)0,
      voxc_r4_4_4_g8_VOLUME_SIZE);
}

// Ends a traversal that takes more steps than any can.
void voxc_r4_4_4_g8_count_step(inout voxc_r4_4_4_g8_Traversal traversal) {
  traversal.steps_left--;
  traversal.cell.x |= traversal.steps_left >> 31; // All bits: outside, whatever follows.
}

bool voxc_r4_4_4_g8_is_in_volume(int3 cell) { return all(uint3(cell) < uint3(voxc_r4_4_4_g8_VOLUME_SIZE)); }

// Whether a traversal is in the box in which it may find something.
bool voxc_r4_4_4_g8_is_in_reach(const voxc_r4_4_4_g8_Traversal traversal) {
  return all(uint3(traversal.cell - traversal.begin) < uint3(traversal.size));
}

// Whether a traversal has more to see here.
bool voxc_r4_4_4_g8_goes_on(const voxc_r4_4_4_g8_Traversal traversal) { return voxc_r4_4_4_g8_is_in_reach(traversal); }

// The low corner of the aligned cube of 2^log2_side voxels a side around a cell.
int3 voxc_r4_4_4_g8_corner_of(int3 cell, int log2_side) { return (cell >> log2_side) << log2_side; }

// The low corner of the cube of an empty span around a cell.
int3 voxc_r4_4_4_g8_corner_of(const voxc_r4_4_4_g8_Ray ray, int3 cell, const voxc_r4_4_4_g8_EmptySpan span) {
  return voxc_r4_4_4_g8_corner_of(cell, span.log2_side) - (~ray.ahead & ((span.count - 1) << span.log2_side));
}

// The faces of an empty span around a cell that lie ahead.
int3 voxc_r4_4_4_g8_faces_ahead(const voxc_r4_4_4_g8_Ray ray, int3 cell, const voxc_r4_4_4_g8_EmptySpan span) {
  int side = 1 << span.log2_side;
  // From the cube's low face to that of the empty span, where the coordinate falls.
  int back = side - (span.count << span.log2_side);
  return (cell & -side) + back + (ray.ahead & (side - back - back));
}

// About when each coordinate passes its face.
float3 voxc_r4_4_4_g8_times_of(const voxc_r4_4_4_g8_Ray ray, float3 face) {
  float3 t = (face - ray.origin) * ray.inverse;
  return t - ray.late;
}

// The order of float32 numbers by their bits is one instruction where others would look for NaN. Negative ones are
// below all others, but of two of them the order is the other one: no t of a face ahead is negative but by rounding.

float voxc_r4_4_4_g8_least_of(float3 of) {
  int3 bits = asint(of);
  return asfloat(min(min(bits.x, bits.y), bits.z));
}

float voxc_r4_4_4_g8_second_least_of(float3 of) {
  int3 bits = asint(of);
  return asfloat(max(min(bits.x, bits.y), min(max(bits.x, bits.y), bits.z)));
}

float voxc_r4_4_4_g8_greatest_of(float3 of) {
  int3 bits = asint(of);
  return asfloat(max(max(bits.x, bits.y), bits.z));
}

// Float32 numbers as integers: significand * 2^(exponent - 150). No device flushes or rounds these.

static const uint voxc_r4_4_4_g8_SIGN_BIT = 0x80000000u;
static const uint voxc_r4_4_4_g8_INFINITY_BITS = 0x7f800000u;

// Below 2^24.
uint voxc_r4_4_4_g8_significand_of(uint bits) {
  uint fraction = bits & 0x7fffffu;
  return (bits & voxc_r4_4_4_g8_INFINITY_BITS) == 0u ? fraction : fraction | 0x800000u;
}

int voxc_r4_4_4_g8_exponent_of(uint bits) { return max(int(bits >> 23 & 0xffu), 1); }

bool voxc_r4_4_4_g8_are_finite(uint3 bits) {
  return all((bits & voxc_r4_4_4_g8_INFINITY_BITS) < (uint3)voxc_r4_4_4_g8_INFINITY_BITS);
}

// True if each is 0 or has a significand of 24 bits, as devices do not always keep smaller ones.
bool voxc_r4_4_4_g8_are_plain(uint3 bits) { return all((bits & ~voxc_r4_4_4_g8_SIGN_BIT) - 1u >= (uint3)0x7fffffu); }

// 2^exponent, for exponents of normal numbers; the nearest such for others.
float voxc_r4_4_4_g8_power_of_two(int exponent) { return asfloat(uint(clamp(exponent, -126, 127) + 127) << 23); }

// The bits of the longest component's magnitude.
uint voxc_r4_4_4_g8_longest_of(uint3 direction) {
  uint3 size = direction & ~voxc_r4_4_4_g8_SIGN_BIT;
  return max(max(size.x, size.y), size.z);
}

// The largest whole numbers that are not above float32 numbers, within 2^22 of zero.
int3 voxc_r4_4_4_g8_floor_of(uint3 bits) {
  int3 whole = int3(clamp(floor(asfloat(bits)), -4194304.0f, 4194304.0f));
  // Below 1, a denormal number may not survive arithmetic.
  int3 small = -int3(bits > (uint3)voxc_r4_4_4_g8_SIGN_BIT);
  return voxc_r4_4_4_g8_mix(whole, small, (bits & ~voxc_r4_4_4_g8_SIGN_BIT) < (uint3)0x3f800000u);
}

// The exact sign of a sum of four products of float32 numbers.

// A sum in two's complement, times 2^(exponent - 300). Its sign is exact, its value within 2^-11 of itself.
struct voxc_r4_4_4_g8_Sum {
  int high;
  uint low;
  int exponent;
};

voxc_r4_4_4_g8_Sum make_voxc_r4_4_4_g8_Sum(int high, uint low, int exponent) {
  voxc_r4_4_4_g8_Sum made;
  made.high = high;
  made.low = low;
  made.exponent = exponent;
  return made;
}

int voxc_r4_4_4_g8_sign_of(const voxc_r4_4_4_g8_Sum sum) {
  return sum.high < 0 ? -1 : (uint(sum.high) | sum.low) != 0u ? 1 : 0;
}

// The largest p for which 2^p is not above the magnitude; -1 for 0, and for -1 too.
int voxc_r4_4_4_g8_log2_of(const voxc_r4_4_4_g8_Sum sum) {
  uint flip = uint(sum.high >> 31);
  uint high = uint(sum.high) ^ flip;
  return int(firstbithigh(high != 0u ? high : sum.low ^ flip)) + (high != 0u ? 32 : 0);
}

// Makes `shift` bits, at most 61, of room at the low end.
void voxc_r4_4_4_g8_shift_left(inout voxc_r4_4_4_g8_Sum sum, int shift) {
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

void voxc_r4_4_4_g8_add(inout voxc_r4_4_4_g8_Sum sum, uint high, uint low, bool negative) {
  uint flip = negative ? ~0u : 0u;
  uint carry_of_low, carry_of_sign;
  uint partial = voxc_r4_4_4_g8_uaddCarry(sum.low, low ^ flip, carry_of_low);
  sum.low = voxc_r4_4_4_g8_uaddCarry(partial, flip & 1u, carry_of_sign);
  sum.high = int(uint(sum.high) + (high ^ flip) + carry_of_low + carry_of_sign);
}

// a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w, of bits of float32. A product is below 2^48 times its power of two.
// They are added from the largest power down; once the sum has 61 bits at the next power, all that is left is too small
// to change its sign.
voxc_r4_4_4_g8_Sum voxc_r4_4_4_g8_sum_of_products(uint4 a, uint4 b) {
  int4 exponent = int4(voxc_r4_4_4_g8_exponent_of(a.x) + voxc_r4_4_4_g8_exponent_of(b.x),
      voxc_r4_4_4_g8_exponent_of(a.y) + voxc_r4_4_4_g8_exponent_of(b.y),
      voxc_r4_4_4_g8_exponent_of(a.z) + voxc_r4_4_4_g8_exponent_of(b.z),
      voxc_r4_4_4_g8_exponent_of(a.w) + voxc_r4_4_4_g8_exponent_of(b.w));
  voxc_r4_4_4_g8_Sum sum = make_voxc_r4_4_4_g8_Sum(0, 0u, 0);
  int left = 4;
  while (left > 0) {
    int largest = max(max(exponent.x, exponent.y), max(exponent.z, exponent.w));
    int next = exponent.x == largest ? 0 : exponent.y == largest ? 1 : exponent.z == largest ? 2 : 3;
    uint high, low;
    voxc_r4_4_4_g8_umulExtended(voxc_r4_4_4_g8_significand_of(a[next]), voxc_r4_4_4_g8_significand_of(b[next]), high,
        low);
    if (voxc_r4_4_4_g8_sign_of(sum) == 0)
      sum.exponent = largest;
    int shift = sum.exponent - largest;
    exponent[next] = -1;
    left--;
    if (voxc_r4_4_4_g8_log2_of(sum) + shift >= 61) {
      left = 0;
    } else {
      voxc_r4_4_4_g8_shift_left(sum, shift);
      voxc_r4_4_4_g8_add(sum, high, low, (a[next] ^ b[next]) >= voxc_r4_4_4_g8_SIGN_BIT);
    }
  }
  return sum;
}

// sum / divisor in plain float32.
float voxc_r4_4_4_g8_quotient(const voxc_r4_4_4_g8_Sum sum, uint divisor) {
  bool negative = sum.high < 0;
  voxc_r4_4_4_g8_Sum magnitude = make_voxc_r4_4_4_g8_Sum(0, 0u, sum.exponent);
  voxc_r4_4_4_g8_add(magnitude, uint(sum.high), sum.low, negative);
  float value = float(magnitude.high) * 4294967296.0f + float(magnitude.low);
  float size = value / float(voxc_r4_4_4_g8_significand_of(divisor)) * voxc_r4_4_4_g8_power_of_two(sum.exponent
      - voxc_r4_4_4_g8_exponent_of(divisor) - 150);
  return negative != (divisor >= voxc_r4_4_4_g8_SIGN_BIT) ? -size : size;
}

// The moments at which a ray changes cell, in exact order. Cells are half-open, so where several coordinates pass a
// face at one t, rising ones change cell first, falling ones just after.

// A change of cell.
struct voxc_r4_4_4_g8_Crossing {
  float t;     // Approximate.
  int axis;    // One that changes,
  int face;    // and the face that it passes.
  int3 step;   // The change, a cell at most on each axis.
  bool rising; // Only rising coordinates change: those that fall may still stand on a boundary.
};

// The change of cell where a ray leaves a cube through the faces ahead: `crossed` tells the axes whose coordinates pass
// them first, about at t.
voxc_r4_4_4_g8_Crossing voxc_r4_4_4_g8_crossing_of(const voxc_r4_4_4_g8_Ray ray, int3 face, float t, bool3 crossed) {
  int3 changes = voxc_r4_4_4_g8_mix((int3)0, ray.heading, crossed);
  int3 risen = max(changes, (int3)0);
  voxc_r4_4_4_g8_Crossing crossing;
  crossing.rising = any(risen != ((int3)0));
  crossing.step = crossing.rising ? risen : changes;
  crossing.axis = crossing.step.x != 0 ? 0 : crossing.step.y != 0 ? 1 : 2;
  crossing.t = t;
  crossing.face = face[crossing.axis];
  return crossing;
}

// Cells from `least` to `most`.
struct voxc_r4_4_4_g8_Range {
  int3 least;
  int3 most;
};

voxc_r4_4_4_g8_Range make_voxc_r4_4_4_g8_Range(int3 least, int3 most) {
  voxc_r4_4_4_g8_Range made;
  made.least = least;
  made.most = most;
  return made;
}

// How far coordinate a is behind at_a when coordinate b passes at_b, with the sign of both speeds:
// (at_a - origin_a) * direction_b - (at_b - origin_b) * direction_a.
voxc_r4_4_4_g8_Sum voxc_r4_4_4_g8_crossing_difference(const voxc_r4_4_4_g8_Ray ray, int a, float at_a, int b,
    float at_b) {
  uint speed_a = ray.given_direction[a];
  uint speed_b = ray.given_direction[b];
  return voxc_r4_4_4_g8_sum_of_products(uint4(asuint(at_a), ray.given_origin[a] ^ voxc_r4_4_4_g8_SIGN_BIT,
      asuint(at_b) ^ voxc_r4_4_4_g8_SIGN_BIT, ray.given_origin[b]), uint4(speed_b, speed_b, speed_a, speed_a));
}

// -1 if coordinate a passes its face first, 0 if both pass theirs at the same t, else 1. Both move.
int voxc_r4_4_4_g8_compare_exactly(const voxc_r4_4_4_g8_Ray ray, int a, int face_a, int b, int face_b) {
  voxc_r4_4_4_g8_Sum difference = voxc_r4_4_4_g8_crossing_difference(ray, a, float(face_a), b, float(face_b));
  int order = voxc_r4_4_4_g8_sign_of(difference);
  return ray.falls[a] == ray.falls[b] ? order : -order;
}

// The same, by doubles where they can decide.
int voxc_r4_4_4_g8_compare_crossings(const voxc_r4_4_4_g8_Ray ray, int a, int face_a, int b, int face_b) {
  return voxc_r4_4_4_g8_compare_exactly(ray, a, face_a, b, face_b);
}

int voxc_r4_4_4_g8_undecided_axis(const voxc_r4_4_4_g8_Range range) {
  return range.least.x != range.most.x ? 0 : range.least.y != range.most.y ? 1 : 2;
}

int voxc_r4_4_4_g8_middle_of(const voxc_r4_4_4_g8_Range range, int axis) {
  return range.least[axis] + (range.most[axis] - range.least[axis] + 1) / 2;
}

// Takes away from a range what lies to one side of a face, where `order` compares it with the crossing.
void voxc_r4_4_4_g8_narrow(const voxc_r4_4_4_g8_Ray ray, const voxc_r4_4_4_g8_Crossing crossing, int axis, int face,
    int order, inout voxc_r4_4_4_g8_Range range) {
  bool falls = ray.falls[axis];
  bool passed = order < 0 || (order == 0 && !(falls && crossing.rising));
  if (passed != falls)
    range.least[axis] = face;
  else
    range.most[axis] = face - 1;
}

// Narrows a range down, on each axis, to the cell that the ray is in once a crossing has happened.
int3 voxc_r4_4_4_g8_resolve_cell(const voxc_r4_4_4_g8_Ray ray, const voxc_r4_4_4_g8_Crossing crossing,
    const voxc_r4_4_4_g8_Range candidates) {
  voxc_r4_4_4_g8_Range range = candidates;
  while (any(range.least != (range.most))) {
    int axis = voxc_r4_4_4_g8_undecided_axis(range);
    int face = voxc_r4_4_4_g8_middle_of(range, axis);
    voxc_r4_4_4_g8_narrow(ray, crossing, axis, face, voxc_r4_4_4_g8_compare_crossings(ray, axis, face, crossing.axis,
        crossing.face), range);
  }
  return range.least;
}

// What can be told, without integers, of the cell, within a range, that the ray is in once a crossing has happened.
voxc_r4_4_4_g8_Range voxc_r4_4_4_g8_approximate_cell(const voxc_r4_4_4_g8_Ray ray,
    const voxc_r4_4_4_g8_Crossing crossing, const voxc_r4_4_4_g8_Range range) {
  float3 point_ = ray.origin_low + crossing.t * ray.direction;
  float3 bound = voxc_r4_4_4_g8_mix((float3)0.0f, (float3)ray.coordinate_error, ray.moves);
  float3 least = float3(range.least);
  float3 most = float3(range.most);
  return make_voxc_r4_4_4_g8_Range(int3(clamp(floor(point_), least, most)), int3(clamp(floor(point_ + bound), least,
      most)));
}

// Steps that are exact for every ray: by float32 or doubles where these can decide, by integers elsewhere.

// How the ray leaves cells through the first of the faces ahead. Not sure if its t cannot decide which that is.
voxc_r4_4_4_g8_Exit voxc_r4_4_4_g8_leave(const voxc_r4_4_4_g8_Ray ray, float3 face) {
  float3 t = voxc_r4_4_4_g8_times_of(ray, face);
  float first = voxc_r4_4_4_g8_least_of(t);
  float second = voxc_r4_4_4_g8_second_least_of(t); // Of negative ones, none that is sure.
  return make_voxc_r4_4_4_g8_Exit(first, t == (float3)first,
      second > first + (first * voxc_r4_4_4_g8_ROUNDINGS + ray.t_error));
}

// The cell that a ray comes to where it leaves others, of which `cell` is one, by one of the faces ahead. Not sure if
// its point cannot decide on which side of another face that is.
int3 voxc_r4_4_4_g8_cell_beyond(const voxc_r4_4_4_g8_Ray ray, float3 face, inout voxc_r4_4_4_g8_Exit leaving) {
  float3 point_ = voxc_r4_4_4_g8_mix(ray.origin_low + leaving.t * ray.direction, face + ray.beyond, leaving.passed);
  float3 whole = floor(point_);
  bool is_certain = voxc_r4_4_4_g8_greatest_of(point_ - whole) < ray.cell_margin;
  leaving.sure = leaving.sure && is_certain;
  return int3(whole);
}

// Resolves the step over the empty span around the traversal's cell: which faces the ray passes first, of those that
// float32 cannot decide apart, and then by bisection to which cell it comes. All questions are asked at one place,
// since devices of wide vectors run through it as often as any ray needs it. Where the device cuts it short, the
// traversal stays where it is.
voxc_r4_4_4_g8_Traversal voxc_r4_4_4_g8_exact_step(const voxc_r4_4_4_g8_Ray ray, voxc_r4_4_4_g8_Traversal traversal,
    const voxc_r4_4_4_g8_EmptySpan span) {
  int side = span.count << span.log2_side;
  int3 corner = voxc_r4_4_4_g8_corner_of(ray, traversal.cell, span);
  int3 face = corner + (ray.ahead & side);
  float3 t = voxc_r4_4_4_g8_times_of(ray, float3(face));
  float earliest = min(min(t.x, t.y), t.z);
  bool3 may_be_first = t <= (float3)(earliest + (earliest * voxc_r4_4_4_g8_ROUNDINGS + ray.t_error));
  int3 bits = int3(may_be_first) * int3(ray.moves);
  int axes = bits.x | bits.y << 1 | bits.z << 2;
  int first = int(firstbitlow(uint(axes)));
  axes &= axes - 1;
  bool3 crossed = bool3(first == 0, first == 1, first == 2);
  voxc_r4_4_4_g8_Crossing crossing;
  voxc_r4_4_4_g8_Range range = make_voxc_r4_4_4_g8_Range((int3)0, (int3)1);
  bool orders = true;
  int order = 0;
  while (any(range.least != (range.most))) {
    if (orders && axes == 0) {
      orders = false;
      crossing = voxc_r4_4_4_g8_crossing_of(ray, face, earliest, crossed);
      int3 target = corner + crossing.step * side;
      range = voxc_r4_4_4_g8_approximate_cell(ray, crossing, make_voxc_r4_4_4_g8_Range(target, target + (side - 1)));
    }
    if (orders || any(range.least != (range.most))) {
      int axis = orders ? int(firstbitlow(uint(axes))) : voxc_r4_4_4_g8_undecided_axis(range);
      int at = orders ? face[axis] : voxc_r4_4_4_g8_middle_of(range, axis);
      order = voxc_r4_4_4_g8_compare_crossings(ray, axis, at, first, face[first]);
      if (!orders) {
        voxc_r4_4_4_g8_narrow(ray, crossing, axis, at, order, range);
      } else {
        if (order <= 0) {
          bool3 others = order < 0 ? (bool3)false : crossed;
          crossed = bool3(others.x || axis == 0, others.y || axis == 1, others.z || axis == 2);
          first = axis;
        }
        axes &= axes - 1;
      }
    }
  }
  if (all(range.least == (range.most))) {
    traversal.cell = range.least;
    traversal.axis = crossing.axis;
  }
  return traversal;
}

// Resolves the step of a traversal that is pending.
void voxc_r4_4_4_g8_resolve_step(const voxc_r4_4_4_g8_Ray ray, inout voxc_r4_4_4_g8_Traversal traversal) {
  voxc_r4_4_4_g8_EmptySpan span = make_voxc_r4_4_4_g8_EmptySpan(traversal.pending_step & 31,
      traversal.pending_step >> 5);
  traversal.pending_step = voxc_r4_4_4_g8_NO_PENDING_STEP;
  traversal.cell = ~traversal.cell;
  traversal = voxc_r4_4_4_g8_exact_step(ray, traversal, span);
}

// Steps from one cell of the ray to the next.

// Ends a step over the empty span around the traversal's cell, or over that and more, which leads to another cell if
// that is sure.
void voxc_r4_4_4_g8_end_step(inout voxc_r4_4_4_g8_Traversal traversal, const voxc_r4_4_4_g8_Exit leaving, int3 cell,
    const voxc_r4_4_4_g8_EmptySpan span) {
  traversal.axis = leaving.passed.z ? 2 : leaving.passed.y ? 1 : 0;
  bool sure = leaving.sure;
  // A step that is not sure is left pending, and all loops end: what resolves it stands outside of them, where lanes
  // that are sure need not wait for it.
  // The next turn may read what is there before it is known if the step is sure.
  traversal.cell = sure ? cell : ~traversal.cell;
  traversal.pending_step = sure ? voxc_r4_4_4_g8_NO_PENDING_STEP : span.count << 5 | span.log2_side;
  voxc_r4_4_4_g8_count_step(traversal);
}

// Steps over the empty span around the traversal's cell, of which these faces lie ahead.
void voxc_r4_4_4_g8_step_over(const voxc_r4_4_4_g8_Ray ray, inout voxc_r4_4_4_g8_Traversal traversal,
    const voxc_r4_4_4_g8_EmptySpan span, float3 face) {
  voxc_r4_4_4_g8_Exit leaving = voxc_r4_4_4_g8_leave(ray, face);
  int3 cell = voxc_r4_4_4_g8_cell_beyond(ray, face, leaving);
  voxc_r4_4_4_g8_end_step(traversal, leaving, cell, span);
}

// Steps over the empty span around the traversal's cell.
void voxc_r4_4_4_g8_step_over(const voxc_r4_4_4_g8_Ray ray, inout voxc_r4_4_4_g8_Traversal traversal,
    const voxc_r4_4_4_g8_EmptySpan span) {
  voxc_r4_4_4_g8_step_over(ray, traversal, span, float3(voxc_r4_4_4_g8_faces_ahead(ray, traversal.cell, span)));
}

// Steps over the empty cube of 2^log2_side voxels a side around the traversal's cell.
void voxc_r4_4_4_g8_step_over(const voxc_r4_4_4_g8_Ray ray, inout voxc_r4_4_4_g8_Traversal traversal, int log2_side) {
  voxc_r4_4_4_g8_step_over(ray, traversal, make_voxc_r4_4_4_g8_EmptySpan(log2_side, 1));
}

// Steps from the traversal's voxel, which is empty, to the next.
void voxc_r4_4_4_g8_step_over_voxel(const voxc_r4_4_4_g8_Ray ray, inout voxc_r4_4_4_g8_Traversal traversal) {
  voxc_r4_4_4_g8_Exit leaving = voxc_r4_4_4_g8_leave(ray, float3(traversal.cell - ray.ahead));
  voxc_r4_4_4_g8_end_step(traversal, leaving, traversal.cell + voxc_r4_4_4_g8_mix((int3)0, ray.heading, leaving.passed),
      make_voxc_r4_4_4_g8_EmptySpan(0, 1));
}

// Rays that begin far away, whose numbers would be too wrong to tell anything of a volume: they are moved along
// themselves until they begin near it.
// A ray is moved by a moment of which 12 bits are set, so that the moment times the upper 12 bits of a component of the
// direction is a float32, and times the lower 12 bits too: no product is rounded. What is summed up is kept as two
// float32, `high` and `low`, of which the lower one is wrong by a few of its own roundings. A ray that comes to the
// volume after a moment M, D < 2 M voxels long, begins at most the volume's size and D away from it, so that a move
// loses less than 2^-43 (2 D + far_away()), whichever way sums are rounded. It ends before the volume, at 2^-11 of the
// distance.
// A move keeps where the ray goes, so that nothing that is exact is touched: only what float32 says of it.

// The distance in voxels beyond which a ray is far.
float voxc_r4_4_4_g8_far_away() {
  int side = max(max(voxc_r4_4_4_g8_VOLUME_SIZE.x, voxc_r4_4_4_g8_VOLUME_SIZE.y), voxc_r4_4_4_g8_VOLUME_SIZE.z);
  // In doubles, of a component that was raised to LEAST_COMPONENT, a t that is not larger makes less than one rounding.
  return float(2 * side);
}

// What is known of a ray that may have been moved.
struct voxc_r4_4_4_g8_Start {
  bool is_far;   // It still begins far away, and float32 tells nothing of it.
  float wrong;   // What may be wrong of its coordinates, beside a few roundings,
  float t_error; // and of a t.
};

voxc_r4_4_4_g8_Start make_voxc_r4_4_4_g8_Start(bool is_far, float wrong, float t_error) {
  voxc_r4_4_4_g8_Start made;
  made.is_far = is_far;
  made.wrong = wrong;
  made.t_error = t_error;
  return made;
}

bool voxc_r4_4_4_g8_is_far(float3 coordinate, bool3 moves) {
  return any(abs(coordinate) > voxc_r4_4_4_g8_mix((float3)voxc_r4_4_4_g8_NEVER, (float3)voxc_r4_4_4_g8_far_away(),
      moves));
}

// Moves coordinates. Those in float32 are sums of two: what the first sum loses is added to the second. Doubles lose
// one rounding of 2^-53.
void voxc_r4_4_4_g8_move_by(float3 way, inout float3 high, inout float3 low) {
  precise float3 sum = high + way;
  precise float3 of_way = sum - high;
  precise float3 of_high = sum - of_way;
  precise float3 lost = (high - of_high) + (way - of_way);
  high = sum;
  low += lost;
}

// Moves a ray that begins far away, to before the last of the faces by which it enters the volume. Once is enough up to
// a thousand times that distance.
voxc_r4_4_4_g8_Start voxc_r4_4_4_g8_come_near(inout voxc_r4_4_4_g8_Ray ray, float3 face) {
  const uint UPPER = 0xfffff000u; // The bits of a float32 but the lowest 12 of its significand.
  const int MOST_MOVES = 3;
  // No ordinary ray is, if none comes near.
  voxc_r4_4_4_g8_Start start = make_voxc_r4_4_4_g8_Start(voxc_r4_4_4_g8_is_far(ray.origin, ray.moves), 0.0f, 0.0f);
  if (!start.is_far)
    return start;
  float3 direction = voxc_r4_4_4_g8_mix((float3)0.0f, ray.direction, ray.moves);
  const float LAST = 18446744073709551616.0f; // 2^64, at least as many voxels away.
  float3 upper = asfloat(asuint(direction) & UPPER);
  float3 high = ray.origin, low = (float3)0.0f;
  float latest = 0.0f;
  for (int moves = 0; moves < MOST_MOVES && start.is_far; moves++) {
    float3 t = voxc_r4_4_4_g8_mix((float3)-voxc_r4_4_4_g8_NEVER, (face - high) * ray.inverse, ray.moves);
    latest = max(max(t.x, t.y), t.z);
    bool is_ahead = latest > 0.0f && latest < LAST;
    float moment = is_ahead ? asfloat(asuint(latest * (1.0f - 1.0f / 1048576.0f)) & UPPER) : 0.0f;
    start.wrong += (4.0f * moment + voxc_r4_4_4_g8_far_away()) / 8796093022208.0f; // 2^43.
    voxc_r4_4_4_g8_move_by(moment * upper, high, low);
    voxc_r4_4_4_g8_move_by(moment * (direction - upper), high, low);
    latest -= moment;
    start.is_far = voxc_r4_4_4_g8_is_far(high, ray.moves);
  }
  precise float3 whole = high + low;
  precise float3 behind = low - (whole - high);
  ray.origin = start.is_far ? ray.origin : whole;
  ray.late = start.is_far ? ray.late : voxc_r4_4_4_g8_mix((float3)0.0f, behind * ray.inverse, ray.moves);
  float3 steep = abs(ray.inverse);
  // A t is rounded once more by what comes late, and none in the volume is above that of its last entry and the longest
  // side, which is half of what is far.
  steep = voxc_r4_4_4_g8_mix((float3)0.0f, steep, ray.moves);
  start.t_error = 2.0f * start.wrong * max(max(steep.x, steep.y),
      steep.z) + (latest + 0.5f * voxc_r4_4_4_g8_far_away()) * voxc_r4_4_4_g8_ROUNDINGS / 4.0f;
  start.wrong += voxc_r4_4_4_g8_far_away() / 4194304.0f; // What is behind, and that rounding.
  return start;
}

// Where a traversal begins: in the cell of the ray's origin, or in the first cell of the volume that the ray comes to.

static const float voxc_r4_4_4_g8_CLOSE = 1.0f / 2048.0f; // In voxels.

// Bounds what float32 gets wrong in a traversal through the volume, where the origin itself is wrong by `of_origin`,
// and a t by `t_error`. A coordinate that never changes stays in its cell.
void voxc_r4_4_4_g8_bound_errors(inout voxc_r4_4_4_g8_Ray ray, float3 cell, float of_origin, float t_error) {
  float3 half_size = 0.5f * float3(voxc_r4_4_4_g8_VOLUME_SIZE);
  float3 reach = abs(ray.origin - half_size) + half_size; // To the farther of the volume's two faces.
  float error = voxc_r4_4_4_g8_greatest_of(reach) * voxc_r4_4_4_g8_ROUNDINGS + of_origin;
  error = min(error + 2.0f * t_error, voxc_r4_4_4_g8_NEVER);
  ray.t_error = t_error;
  ray.origin_low = voxc_r4_4_4_g8_mix(cell + 0.25f, ray.origin - error, ray.moves);
  ray.coordinate_error = 2.0f * error;
  ray.cell_margin = 1.0f - ray.coordinate_error;
}

// True where the ray moves from a coordinate so close to 0 that it may pass that face before float32 says so, as scaled
// directions have no component below 2^-60.
bool3 voxc_r4_4_4_g8_starts_tiny(const voxc_r4_4_4_g8_Ray ray) {
  const uint TINY_BITS = 0x30800000u; // Of 2^-30.
  uint3 size = ray.given_origin & ~voxc_r4_4_4_g8_SIGN_BIT;
  bool3 tiny = size - 1u < (uint3)(TINY_BITS - 1u);
  return int3(tiny) * int3(ray.moves) > (int3)0;
}

// Of the axes that let the ray into their slab at a face, the last, where a falling one comes after a rising one.
int voxc_r4_4_4_g8_last_entered(const voxc_r4_4_4_g8_Ray ray, bool3 enters, int3 face) {
  int last = -1;
  for (int axis = 0; axis < 3; axis++) {
    if (enters[axis]) {
      int order;
      if (last < 0)
        order = 1;
      else
        order = voxc_r4_4_4_g8_compare_crossings(ray, axis, face[axis], last, face[last]);
      if (order > 0 || (order == 0 && ray.falls[axis]))
        last = axis;
    }
  }
  return last;
}

// The coordinate, kept within a voxel of the volume, that a ray has where it passes a face. Each turn leaves less than
// 2^-10 of the error of the guess before, and what float32 rounds.
float voxc_r4_4_4_g8_coordinate_at(const voxc_r4_4_4_g8_Ray ray, int axis, int face, int other) {
  float size = float(voxc_r4_4_4_g8_VOLUME_SIZE[other]);
  float at = 0.5f * size;
  for (float error = size; error > voxc_r4_4_4_g8_CLOSE; error *= 1.0f / 1024.0f) {
    float move = voxc_r4_4_4_g8_quotient(voxc_r4_4_4_g8_crossing_difference(ray, axis, float(face), other, at),
        ray.given_direction[axis]);
    at = clamp(at + move, -1.0f, size + 1.0f);
  }
  return at;
}

// Lets a ray from far away start where it passes a face, so that its errors do not grow with its distance.
void voxc_r4_4_4_g8_start_at(inout voxc_r4_4_4_g8_Ray ray, int3 cell, int axis, int face) {
  float error = 0.0f;
  for (int other = 0; other < 3; other++) {
    if (other == axis) {
      ray.origin[other] = float(face);
    } else if (ray.moves[other]) {
      ray.origin[other] = voxc_r4_4_4_g8_coordinate_at(ray, axis, face, other);
      // More than a few roundings.
      error = max(error, voxc_r4_4_4_g8_CLOSE + voxc_r4_4_4_g8_CLOSE * abs(ray.origin[other]) / 256.0f);
    }
  }
  float3 steep = voxc_r4_4_4_g8_mix((float3)0.0f, abs(ray.inverse), ray.moves);
  ray.late = (float3)0.0f;
  voxc_r4_4_4_g8_bound_errors(ray, float3(cell), error, 2.0f * error * max(max(steep.x, steep.y), steep.z));
}

// Puts a traversal into the cell that the ray comes to where it passes a face, in exact arithmetic. `cell` tells the
// coordinates that never change.
voxc_r4_4_4_g8_Traversal voxc_r4_4_4_g8_behind_face(const voxc_r4_4_4_g8_Ray ray, voxc_r4_4_4_g8_Traversal traversal,
    int3 cell, int axis, int face) {
  voxc_r4_4_4_g8_Crossing crossing;
  crossing.t = (float(face) - ray.origin[axis]) * ray.inverse[axis] - ray.late[axis];
  crossing.axis = axis;
  crossing.face = face;
  crossing.rising = !ray.falls[axis];
  voxc_r4_4_4_g8_Range range = make_voxc_r4_4_4_g8_Range(voxc_r4_4_4_g8_mix(cell, (int3)-1, ray.moves),
      voxc_r4_4_4_g8_mix(cell, voxc_r4_4_4_g8_VOLUME_SIZE, ray.moves));
  range.most[axis] = face - (ray.falls[axis] ? 1 : 0);
  range.least[axis] = range.most[axis];
  range = voxc_r4_4_4_g8_approximate_cell(ray, crossing, range);
  int3 behind = range.least;
  behind = voxc_r4_4_4_g8_resolve_cell(ray, crossing, range);
  traversal.cell = behind;
  traversal.axis = axis;
  return traversal;
}

// Finds the cell in which the ray enters the volume, in exact arithmetic: that of its origin, or through the last of
// the faces that it must pass. A cell outside if there is none.
voxc_r4_4_4_g8_Traversal voxc_r4_4_4_g8_entered_exactly(inout voxc_r4_4_4_g8_Ray ray,
    voxc_r4_4_4_g8_Traversal traversal, bool starts_far) {
  int3 cell = voxc_r4_4_4_g8_floor_of(ray.given_origin);
  int3 below = int3(cell < (int3)0);
  int3 above = int3(cell >= voxc_r4_4_4_g8_VOLUME_SIZE);
  int3 enters = below * (int3(ray.moves) - int3(ray.falls)) + above * int3(ray.falls);
  traversal.cell = cell;
  if (all(enters == ((int3)0)) || any(enters != (below + above)))
    return traversal;
  int3 face = voxc_r4_4_4_g8_mix((int3)0, voxc_r4_4_4_g8_VOLUME_SIZE, ray.falls);
  int axis = voxc_r4_4_4_g8_last_entered(ray, enters > (int3)0, face);
  if (starts_far)
    voxc_r4_4_4_g8_start_at(ray, cell, axis, face[axis]);
  return voxc_r4_4_4_g8_behind_face(ray, traversal, cell, axis, face[axis]);
}

// The same by float32 or doubles, of an ordinary ray: it passes the last of these faces, or is past all of them. Not
// sure if that cannot decide which face is the last, or which cell is behind it.
voxc_r4_4_4_g8_Traversal voxc_r4_4_4_g8_entered(const voxc_r4_4_4_g8_Ray ray, voxc_r4_4_4_g8_Traversal traversal,
    float3 face, inout bool sure) {
  // 2^48: a ray of a voxel a moment is past the volume by then, whatever enters last.
  const float LATEST = 281474976710656.0f;
  // A coordinate that never changes stays outside.
  float3 t = voxc_r4_4_4_g8_mix((float3)-1.0f, voxc_r4_4_4_g8_times_of(ray, face), ray.moves);
  bool is_as_given = ray.t_error == 0.0f; // Else it has come near, and does not begin here.
  // From a last face, which is not in the volume, a ray enters at 0; its t is a 0 with a sign.
  float3 last_face = voxc_r4_4_4_g8_mix((float3)voxc_r4_4_4_g8_NEVER, face, ray.falls);
  bool3 on_face = ray.origin == (is_as_given ? last_face : (float3)voxc_r4_4_4_g8_NEVER);
  t = voxc_r4_4_4_g8_mix(t, (float3)0.0f, on_face);
  float latest = min(voxc_r4_4_4_g8_greatest_of(t), LATEST);
  float before = voxc_r4_4_4_g8_second_least_of(t);
  bool3 passed = t == (float3)latest;
  bool begins_here = !(latest > 0.0f) && is_as_given && !any(on_face);
  float3 point_ = voxc_r4_4_4_g8_mix(ray.origin_low + latest * ray.direction, face + ray.beyond, passed);
  point_ = begins_here ? ray.origin : point_;
  float3 whole = floor(point_);
  bool is_last = before < latest - (latest * voxc_r4_4_4_g8_ROUNDINGS + ray.t_error);
  bool is_certain = voxc_r4_4_4_g8_greatest_of(point_ - whole) < ray.cell_margin;
  bool is_sure = begins_here || (is_last && is_certain);
  sure = sure && is_sure;
  traversal.cell = int3(clamp(whole, -1.0f, 4194304.0f));
  traversal.axis = begins_here ? -1 : passed.x ? 0 : passed.y ? 1 : 2;
  return traversal;
}

// True if a coordinate is past the volume, and goes on.
bool voxc_r4_4_4_g8_leaves_volume(const voxc_r4_4_4_g8_Ray ray) {
  int3 below = int3(ray.origin < (float3)0.0f);
  int3 above = int3(ray.origin >= float3(voxc_r4_4_4_g8_VOLUME_SIZE));
  return any(voxc_r4_4_4_g8_mix(above, below, ray.falls) != ((int3)0));
}

// Puts the traversal into the first cell of the volume on the ray; false if there is none, or if the ray is left.
bool voxc_r4_4_4_g8_enter_volume(inout voxc_r4_4_4_g8_Ray ray, inout voxc_r4_4_4_g8_Traversal traversal,
    bool ordinary) {
  if (ordinary && voxc_r4_4_4_g8_leaves_volume(ray))
    return false;
  float3 face = voxc_r4_4_4_g8_mix((float3)0.0f, float3(voxc_r4_4_4_g8_VOLUME_SIZE), ray.falls);
  float3 cell = floor(ray.origin);
  voxc_r4_4_4_g8_Start near = voxc_r4_4_4_g8_come_near(ray, face);
  if (!ordinary && any(voxc_r4_4_4_g8_starts_tiny(ray)))
    near.t_error = voxc_r4_4_4_g8_NEVER;
  voxc_r4_4_4_g8_bound_errors(ray, cell, near.wrong, near.t_error);
  bool has_begun = voxc_r4_4_4_g8_is_in_volume(traversal.cell) || traversal.pending_step >= 0;
  if (has_begun && !near.is_far)
    return true; // Where it has entered need not be found again.
  bool sure = ordinary && !near.is_far;
  voxc_r4_4_4_g8_Traversal start = voxc_r4_4_4_g8_entered(ray, traversal, face, sure);
  if (!sure) {
    // What a function may change by reference stands in memory; the ray itself need not.
    voxc_r4_4_4_g8_Ray moved = ray;
    start = voxc_r4_4_4_g8_entered_exactly(moved, traversal, near.is_far);
    ray = moved;
  }
  traversal = start;
  return voxc_r4_4_4_g8_is_in_volume(traversal.cell);
}

// A ray as given, made ready for the traversal.

static const float voxc_r4_4_4_g8_LEAST_COMPONENT = 1.0f / 1099511627776.0f / 1099511627776.0f; // 2^-80.

// Most rays are ordinary: float32 traverses with them as they are, and nothing overflows or is lost on the way. Their
// direction is scaled without a rounding, all numbers of theirs are then 0 or at least 2^-80, and they begin within
// 2^45 voxels, or near the volume if rays from far away are not moved. `longest` has the bits of the direction's
// longest component, and `component` is the direction once it is scaled.
bool voxc_r4_4_4_g8_is_ordinary(uint3 origin, uint longest, float3 component) {
  const uint SHORTEST = 0x00800000u; // The bits of 2^-126, below which devices may keep no number.
  const uint RANGE = 0x7e800000u; // From there to 2^127, where no number is left to scale by.
  const uint FAR_BITS = 0x56000000u; // Of 2^45.
  uint3 place = origin & ~voxc_r4_4_4_g8_SIGN_BIT;
  uint3 least = min(place - 1u, asuint(abs(component)));
  uint farthest = max(max(place.x, place.y), place.z);
  bool is_scaled = longest - SHORTEST < RANGE;
  bool is_large = min(min(least.x, least.y), least.z) >= asuint(voxc_r4_4_4_g8_LEAST_COMPONENT);
  bool is_near = farthest < FAR_BITS;
  return is_scaled && is_large && is_near;
}

// The magnitudes of a direction, divided by a power of two that leaves the largest in [1, 2), for numbers of any size.
float3 voxc_r4_4_4_g8_scaled_exactly(uint3 size) {
  int3 exponent;
  int largest = -1000;
  for (int axis = 0; axis < 3; axis++) {
    uint significand = voxc_r4_4_4_g8_significand_of(size[axis]);
    exponent[axis] = voxc_r4_4_4_g8_exponent_of(size[axis]) + int(firstbithigh(significand));
    largest = significand != 0u ? max(largest, exponent[axis]) : largest;
  }
  float3 result;
  for (int axis = 0; axis < 3; axis++) {
    uint significand = voxc_r4_4_4_g8_significand_of(size[axis]);
    result[axis] = float(significand) * voxc_r4_4_4_g8_power_of_two(-int(firstbithigh(significand)))
        * voxc_r4_4_4_g8_power_of_two(max(exponent[axis] - largest, -60));
  }
  return result;
}

// Makes a ray ready, whose direction is scaled by a power of two so that its longest component is in [1, 2).
voxc_r4_4_4_g8_Ray voxc_r4_4_4_g8_prepare_ray(uint3 origin, uint3 direction, out bool ordinary) {
  voxc_r4_4_4_g8_Ray ray;
  ray.given_origin = origin;
  ray.given_direction = direction;
  uint3 size = direction & ~voxc_r4_4_4_g8_SIGN_BIT;
  uint longest = voxc_r4_4_4_g8_longest_of(direction);
  ray.moves = size != (uint3)0u;
  float3 component = asfloat(direction) * asfloat(0x7f000000u - (longest & voxc_r4_4_4_g8_INFINITY_BITS));
  component = voxc_r4_4_4_g8_mix((float3)voxc_r4_4_4_g8_LEAST_COMPONENT, component, ray.moves);
  ordinary = voxc_r4_4_4_g8_is_ordinary(origin, longest, component);
  ray.plain = ordinary;
  if (!ordinary) {
    ray.plain = voxc_r4_4_4_g8_are_plain(origin) && voxc_r4_4_4_g8_are_plain(direction);
    component = voxc_r4_4_4_g8_mix((float3)1.0f, (float3)-1.0f,
        direction > (uint3)voxc_r4_4_4_g8_SIGN_BIT) * voxc_r4_4_4_g8_scaled_exactly(size);
    component = voxc_r4_4_4_g8_mix((float3)voxc_r4_4_4_g8_LEAST_COMPONENT, component, ray.moves);
  }
  int3 sign = asint(component) >> 31;
  ray.origin = asfloat(origin);
  ray.direction = component;
  ray.inverse = 1.0f / ray.direction;
  ray.late = (float3)0.0f;
  ray.falls = sign < (int3)0;
  ray.heading = sign | 1;
  ray.beyond = float3(sign);
  ray.ahead = ~sign;
  return ray;
}

// From a ray to its traversal, and the end of the traversal.

// A ray that goes nowhere can hit its own cell alone: it is let go anywhere, and takes no later hit.
bool voxc_r4_4_4_g8_goes_nowhere(uint3 direction) {
  return ((direction.x | direction.y | direction.z) & ~voxc_r4_4_4_g8_SIGN_BIT) == 0u;
}

// Makes a ray ready, and its traversal too, if that has not begun. False if there is nothing to go through, or if the
// ray is left.
bool voxc_r4_4_4_g8_begin_traversal(uint3 origin, uint3 direction, uint root, out voxc_r4_4_4_g8_Ray ray,
    inout voxc_r4_4_4_g8_Traversal traversal) {
  bool stays = voxc_r4_4_4_g8_goes_nowhere(direction);
  bool ordinary;
  ray = voxc_r4_4_4_g8_prepare_ray(origin, stays ? uint3(asuint(1.0f), 0u, 0u) : direction, ordinary);
  if (root == 0u)
    return false;
  if (!(voxc_r4_4_4_g8_are_finite(origin) && voxc_r4_4_4_g8_are_finite(direction)))
    return false;
  voxc_r4_4_4_g8_Traversal start = traversal;
  bool enters = voxc_r4_4_4_g8_enter_volume(ray, start, ordinary);
  bool may_have_begun = true; // A dispatch without the exact fallback begins all its rays.
  bool has_begun = may_have_begun && (voxc_r4_4_4_g8_is_in_volume(traversal.cell)
      || traversal.pending_step != voxc_r4_4_4_g8_NO_PENDING_STEP);
  if (!enters || !has_begun)
    traversal = start;
  return enters;
}

// What becomes of a hit: a ray that goes nowhere loses what is not in its own cell, once its traversal has begun.
bool voxc_r4_4_4_g8_end_traversal(uint3 origin, uint3 direction, inout voxc_r4_4_4_g8_Traversal traversal, bool hit) {
  bool may_stay = true; // Packets go on with rays that exact arithmetic has prepared.
  if (!may_stay || !voxc_r4_4_4_g8_goes_nowhere(direction) || traversal.pending_step == voxc_r4_4_4_g8_RETRY
      || all(traversal.cell == (voxc_r4_4_4_g8_floor_of(origin))))
    return hit;
  traversal.cell = (int3)-1;
  traversal.pending_step = voxc_r4_4_4_g8_NO_PENDING_STEP;
  return false;
}

// The t of a face, correctly rounded, in integers.

// An unsigned number of 64 bits.
struct voxc_r4_4_4_g8_Wide {
  uint high;
  uint low;
};

voxc_r4_4_4_g8_Wide make_voxc_r4_4_4_g8_Wide(uint high, uint low) {
  voxc_r4_4_4_g8_Wide made;
  made.high = high;
  made.low = low;
  return made;
}

bool voxc_r4_4_4_g8_is_below(const voxc_r4_4_4_g8_Wide a, const voxc_r4_4_4_g8_Wide b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}

voxc_r4_4_4_g8_Wide voxc_r4_4_4_g8_sum_of(const voxc_r4_4_4_g8_Wide a, const voxc_r4_4_4_g8_Wide b) {
  uint carry;
  uint low = voxc_r4_4_4_g8_uaddCarry(a.low, b.low, carry);
  return make_voxc_r4_4_4_g8_Wide(a.high + b.high + carry, low);
}

voxc_r4_4_4_g8_Wide voxc_r4_4_4_g8_difference_of(const voxc_r4_4_4_g8_Wide a, const voxc_r4_4_4_g8_Wide b) {
  uint borrow;
  uint low = voxc_r4_4_4_g8_usubBorrow(a.low, b.low, borrow);
  return make_voxc_r4_4_4_g8_Wide(a.high - b.high - borrow, low);
}

int voxc_r4_4_4_g8_log2_of(const voxc_r4_4_4_g8_Wide number) {
  return number.high != 0u ? 32 + int(firstbithigh(number.high)) : int(firstbithigh(number.low));
}

// number * 2^shift, shift in [-63, 63]. Bits that fall off the low end are told of; none falls off the high end.
voxc_r4_4_4_g8_Wide voxc_r4_4_4_g8_shifted(const voxc_r4_4_4_g8_Wide number, int shift, inout bool inexact) {
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
  return make_voxc_r4_4_4_g8_Wide(high, low);
}

// A number of 50 bits, times 2^exponent.
struct voxc_r4_4_4_g8_Distance {
  voxc_r4_4_4_g8_Wide number;
  int exponent;
  bool inexact; // The exact distance is a little more.
};

voxc_r4_4_4_g8_Distance make_voxc_r4_4_4_g8_Distance(voxc_r4_4_4_g8_Wide number, int exponent, bool inexact) {
  voxc_r4_4_4_g8_Distance made;
  made.number = number;
  made.exponent = exponent;
  made.inexact = inexact;
  return made;
}

// |face - origin|, its leading 50 bits.
voxc_r4_4_4_g8_Distance voxc_r4_4_4_g8_distance_to(uint face, uint origin) {
  uint significand = voxc_r4_4_4_g8_significand_of(origin);
  int exponent = voxc_r4_4_4_g8_exponent_of(origin) - 150;
  // The larger of the two has its first bit at place 61, and so none below place 0.
  int top = max(face == 0u ? -1000 : int(firstbithigh(face)),
      significand == 0u ? -1000 : exponent + int(firstbithigh(significand)));
  voxc_r4_4_4_g8_Distance distance = make_voxc_r4_4_4_g8_Distance(make_voxc_r4_4_4_g8_Wide(0u, 0u), 0, false);
  voxc_r4_4_4_g8_Wide a = voxc_r4_4_4_g8_shifted(make_voxc_r4_4_4_g8_Wide(0u, face), clamp(61 - top, -63, 63),
      distance.inexact);
  voxc_r4_4_4_g8_Wide b = voxc_r4_4_4_g8_shifted(make_voxc_r4_4_4_g8_Wide(0u, significand), clamp(61 - top + exponent,
      -63, 63), distance.inexact);
  if (origin >= voxc_r4_4_4_g8_SIGN_BIT) {
    a = voxc_r4_4_4_g8_sum_of(a, b);
  } else {
    if (voxc_r4_4_4_g8_is_below(a, b))
      a = voxc_r4_4_4_g8_difference_of(b, a);
    else
      a = voxc_r4_4_4_g8_difference_of(a, b);
    // What fell off was to be taken away.
    if (distance.inexact)
      a = voxc_r4_4_4_g8_difference_of(a, make_voxc_r4_4_4_g8_Wide(0u, 1u));
  }
  int place = voxc_r4_4_4_g8_log2_of(a) - 49;
  distance.number = voxc_r4_4_4_g8_shifted(a, -place, distance.inexact);
  distance.exponent = top - 61 + place;
  return distance;
}

// value * 2^exponent of a value below 2^27, rounded to the nearest float32, ties to even; `inexact` if it is a little
// more.
uint voxc_r4_4_4_g8_rounded(uint value, int exponent, bool inexact) {
  int log2_value = int(firstbithigh(value)) + exponent;
  if (log2_value > 127)
    return voxc_r4_4_4_g8_INFINITY_BITS;
  int drop = min(int(firstbithigh(value)) - 23 + max(-126 - log2_value, 0), 31);
  uint kept = value >> drop;
  uint rest = value & ((1u << drop) - 1u);
  uint middle = 1u << (drop - 1);
  if (rest > middle || (rest == middle && (inexact || (kept & 1u) != 0u)))
    kept++;
  return min((uint(max(log2_value + 126, 0)) << 23) + kept, voxc_r4_4_4_g8_INFINITY_BITS);
}

// When the ray passes a face ahead of its origin: |face - origin| / |direction|, as bits of float32.
uint voxc_r4_4_4_g8_time_exactly(const voxc_r4_4_4_g8_Ray ray, int axis, int face) {
  voxc_r4_4_4_g8_Distance distance = voxc_r4_4_4_g8_distance_to(uint(face), ray.given_origin[axis]);
  if (distance.number.high == 0u)
    return 0u;
  uint divisor = voxc_r4_4_4_g8_significand_of(ray.given_direction[axis]);
  int shift = 23 - int(firstbithigh(divisor));
  divisor <<= shift;
  // The quotient, below 2^27, by an estimate that an exact remainder corrects: what float32 rounds leaves it wrong by
  // less than 100, so the remainder fits 32 bits; the quotient of that is wrong by 1 at most.
  float size = float(divisor);
  float estimate = (float(distance.number.high) * 4294967296.0f + float(distance.number.low)) / size;
  uint value = uint(estimate);
  uint high, low;
  voxc_r4_4_4_g8_umulExtended(value, divisor, high, low);
  int rest = int(distance.number.low - low);
  int more = int(floor(float(rest) / size));
  rest -= more * int(divisor);
  int last = rest < 0 ? -1 : rest >= int(divisor) ? 1 : 0;
  value += uint(more + last);
  rest -= last * int(divisor);
  int exponent = distance.exponent - (voxc_r4_4_4_g8_exponent_of(ray.given_direction[axis]) - 150 - shift);
  return voxc_r4_4_4_g8_rounded(value, exponent, distance.inexact || rest != 0);
}

// The same, as fast as it can be told. Where a device promises little of its arithmetic, integers tell it of every hit:
// a dispatch that does not resolve would defer each of them to one with it.
uint voxc_r4_4_4_g8_crossing_time(const voxc_r4_4_4_g8_Ray ray, int axis, int face, out bool sure) {
  sure = false;
  uint bits = 0u;
  if (!sure) {
    bits = voxc_r4_4_4_g8_time_exactly(ray, axis, face);
    sure = true;
  }
  return bits;
}

// The face through which the ray entered its cell.
int voxc_r4_4_4_g8_entered_face(const voxc_r4_4_4_g8_Ray ray, const voxc_r4_4_4_g8_Traversal traversal) {
  return traversal.cell[traversal.axis] + (ray.falls[traversal.axis] ? 1 : 0);
}

// How a ray comes to the voxel that it hits.
struct voxc_r4_4_4_g8_Arrival {
  uint t;    // The bits of a float32.
  uint face; // Twice the axis on which the ray enters, and 1 more where its coordinate falls.
};

static const uint voxc_r4_4_4_g8_BEGINS_INSIDE = 6u; // No face.

// True if the ray comes into its cell on two axes at one moment.
bool voxc_r4_4_4_g8_enters_together(const voxc_r4_4_4_g8_Ray ray, int3 face, int a, int b) {
  if (!(ray.moves[a] && ray.falls[a] == ray.falls[b]))
    return false;
  return voxc_r4_4_4_g8_compare_crossings(ray, a, face[a], b, face[b]) == 0;
}

// The first axis on which the ray comes into the traversal's cell as it enters that. Not sure if steps cannot decide.
// Without exactness, of several, at an edge, the one that the traversal has met.
int voxc_r4_4_4_g8_first_axis(const voxc_r4_4_4_g8_Ray ray, const voxc_r4_4_4_g8_Traversal traversal, out bool sure) {
  sure = true;
  int first = traversal.axis;
  int3 face = traversal.cell + int3(ray.falls);
  float3 t = voxc_r4_4_4_g8_times_of(ray, float3(face));
  for (int axis = 0; axis < 2; axis++) {
    float apart = abs(t[axis] - t[traversal.axis]);
    float bound = min(abs(t[axis]), abs(t[traversal.axis])) * voxc_r4_4_4_g8_ROUNDINGS + ray.t_error;
    if (axis < first && ray.moves[axis] && ray.falls[axis] == ray.falls[traversal.axis] && !(apart > bound))
      sure = false;
  }
  if (!sure) {
    sure = true;
    for (int axis = 1; axis >= 0; axis--) {
      bool chosen_1;
      chosen_1 = axis < traversal.axis;
      if (chosen_1)
        chosen_1 = voxc_r4_4_4_g8_enters_together(ray, face, axis, traversal.axis);
      first = chosen_1 ? axis : first;
    }
  }
  return first;
}

// How the ray came to the traversal's cell. Not sure where float32 or doubles cannot decide.
voxc_r4_4_4_g8_Arrival voxc_r4_4_4_g8_arrival_at(const voxc_r4_4_4_g8_Ray ray, const voxc_r4_4_4_g8_Traversal traversal,
    bool hit, out bool sure) {
  voxc_r4_4_4_g8_Arrival arrival;
  arrival.t = 0u;
  arrival.face = voxc_r4_4_4_g8_BEGINS_INSIDE;
  sure = true;
  if (!hit || traversal.axis < 0)
    return arrival;
  arrival.t = voxc_r4_4_4_g8_crossing_time(ray, traversal.axis, voxc_r4_4_4_g8_entered_face(ray, traversal), sure);
  bool sure_of_axis;
  int axis = voxc_r4_4_4_g8_first_axis(ray, traversal, sure_of_axis);
  arrival.face = 2u * uint(axis) + uint(ray.falls[axis]);
  sure = sure && sure_of_axis;
  return arrival;
}

// A single voxel: the traversal has arrived.
bool voxc_r4_4_4_g8_intersect_voxel(inout voxc_r4_4_4_g8_Traversal traversal, uint voxel) {
  traversal.voxel = voxel;
  return true;
}

// ---- The format: R(4, 4, 4) G(8) ----

// Which child of a node a place lies in, counted in children.
int voxc_r4_4_4_g8_child_index(int3 place) {
  int3 bits = place & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}

// Level 2: svdag, 256 x 256 x 256 cells of 1 voxel a side.
static const int voxc_r4_4_4_g8_LEVEL_2_DEPTH = 8;
static const int voxc_r4_4_4_g8_LEVEL_2_LOG2_CELL = 0;
static const int voxc_r4_4_4_g8_LEVEL_2_LOG2_SIDE = 8;

// A node is [masks, slots of its children...]: a bit for each child that is not empty, one for each that is a leaf, and
// slots of those that are not empty or, where all leaves have one value, that are neither empty nor leaves. Gives the
// child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint voxc_r4_4_4_g8_child_level_2(VOXC_VOLUME volume, uint node, int3 cell, int height, out bool leaf) {
  int child = voxc_r4_4_4_g8_child_index(cell >> height);
  uint masks = voxc_r4_4_4_g8_load_word(volume, node);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return voxc_r4_4_4_g8_load_word(volume, node + 1u + uint(int(countbits(masks & ((1u << child) - 1u)))));
}

// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
// old cell and the new.
bool voxc_r4_4_4_g8_intersect_level_2(VOXC_VOLUME volume, const voxc_r4_4_4_g8_Ray ray,
    inout voxc_r4_4_4_g8_Traversal traversal, uint root) {
  uint path[voxc_r4_4_4_g8_LEVEL_2_DEPTH + 1];
  path[voxc_r4_4_4_g8_LEVEL_2_DEPTH] = root;
  int top = voxc_r4_4_4_g8_LEVEL_2_DEPTH;
  for (;;) {
    int3 cell = traversal.cell >> voxc_r4_4_4_g8_LEVEL_2_LOG2_CELL;
    uint node = path[top];
    int layer = top;
    bool leaf = false;
    while (node != 0u && !leaf) {
      path[layer] = node;
      layer--;
      node = voxc_r4_4_4_g8_child_level_2(volume, node, cell, layer, leaf);
    }
    int3 before = traversal.cell;
    if (node == 0u)
      voxc_r4_4_4_g8_step_over(ray, traversal, voxc_r4_4_4_g8_LEVEL_2_LOG2_CELL + layer);
    else {
      bool chosen_1;
      chosen_1 = leaf;
      if (chosen_1)
        chosen_1 = voxc_r4_4_4_g8_intersect_voxel(traversal, node);
      if (chosen_1)
        return true;
    }
    int3 changed = before ^ traversal.cell;
    int highest = int(firstbithigh(uint(changed.x | changed.y | changed.z)));
    if (highest >= voxc_r4_4_4_g8_LEVEL_2_LOG2_SIDE)
      return false;
    top = max(layer, highest - voxc_r4_4_4_g8_LEVEL_2_LOG2_CELL) + 1;
  }
}

// Level 1: raw, 16 x 16 x 16 cells of 256 voxels a side.
static const int3 voxc_r4_4_4_g8_LEVEL_1_LOG2_SIZE = int3(4, 4, 4);
static const int voxc_r4_4_4_g8_LEVEL_1_LOG2_CELL = 8;

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
uint voxc_r4_4_4_g8_slot_level_1(uint grid, int3 cell) {
  int3 at = cell;
  return grid + uint(at.x + ((at.y
      + (at.z << voxc_r4_4_4_g8_LEVEL_1_LOG2_SIZE.y)) << voxc_r4_4_4_g8_LEVEL_1_LOG2_SIZE.x));
}

// The value of a cell, or 0 if it is empty.
uint voxc_r4_4_4_g8_cell_level_1(VOXC_VOLUME volume, uint grid, int3 cell) {
  uint slot = voxc_r4_4_4_g8_slot_level_1(grid, cell);
  return voxc_r4_4_4_g8_load_word(volume, slot);
}

bool voxc_r4_4_4_g8_intersect_level_1(VOXC_VOLUME volume, const voxc_r4_4_4_g8_Ray ray,
    inout voxc_r4_4_4_g8_Traversal traversal, uint grid) {
  while (voxc_r4_4_4_g8_goes_on(traversal)) {
    voxc_r4_4_4_g8_EmptySpan span = make_voxc_r4_4_4_g8_EmptySpan(voxc_r4_4_4_g8_LEVEL_1_LOG2_CELL, 1);
    uint value = voxc_r4_4_4_g8_cell_level_1(volume, grid, traversal.cell >> voxc_r4_4_4_g8_LEVEL_1_LOG2_CELL);
    if (value == 0u) {
      voxc_r4_4_4_g8_step_over(ray, traversal, span);
    } else if (voxc_r4_4_4_g8_intersect_level_2(volume, ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
uint voxc_r4_4_4_g8_colour_of(VOXC_VOLUME volume, const voxc_r4_4_4_g8_Traversal traversal) {
  return voxc_r4_4_4_g8_load_word(volume, traversal.voxel);
}

// ---- What follows is the same in every kernel ----

// Goes on with a traversal to its end, or until it is left.
bool voxc_r4_4_4_g8_continue_traversal(VOXC_VOLUME volume, const voxc_r4_4_4_g8_Ray ray,
    inout voxc_r4_4_4_g8_Traversal traversal, uint root) {
  bool hit = false;
  bool is_under_way = true;
  while (is_under_way) {
    while (traversal.pending_step >= 0)
      voxc_r4_4_4_g8_resolve_step(ray, traversal);
    // What was resolved may have been the last step inside.
    hit = voxc_r4_4_4_g8_is_in_volume(traversal.cell);
    if (hit)
      hit = voxc_r4_4_4_g8_intersect_level_1(volume, ray, traversal, root);
    is_under_way = traversal.pending_step >= 0;
  }
  return hit;
}

// What lies between two moments of a ray, tmin and tmax.

// Moments as bits of float32 that are not below 0. Nothing lies between them if tmin > tmax.
struct voxc_r4_4_4_g8_Bounds {
  uint tmin;
  uint tmax;
};

voxc_r4_4_4_g8_Bounds make_voxc_r4_4_4_g8_Bounds(uint tmin, uint tmax) {
  voxc_r4_4_4_g8_Bounds made;
  made.tmin = tmin;
  made.tmax = tmax;
  return made;
}

// The bits of a moment, for which one before 0 is as good as 0.
uint voxc_r4_4_4_g8_moment_of(uint bits) {
  return bits > voxc_r4_4_4_g8_SIGN_BIT && bits <= (voxc_r4_4_4_g8_SIGN_BIT | voxc_r4_4_4_g8_INFINITY_BITS) ? 0u
      : bits & ~voxc_r4_4_4_g8_SIGN_BIT;
}

// The bounds that two float32 tell. A NaN is in no interval, and no voxel is entered at +inf.
voxc_r4_4_4_g8_Bounds voxc_r4_4_4_g8_bounds_between(uint tmin, uint tmax) {
  voxc_r4_4_4_g8_Bounds bounds = make_voxc_r4_4_4_g8_Bounds(voxc_r4_4_4_g8_moment_of(tmin),
      voxc_r4_4_4_g8_moment_of(tmax));
  bool are_bounds = bounds.tmin < voxc_r4_4_4_g8_INFINITY_BITS && tmax <= voxc_r4_4_4_g8_SIGN_BIT
      && bounds.tmax <= voxc_r4_4_4_g8_INFINITY_BITS;
  if (!are_bounds)
    bounds = make_voxc_r4_4_4_g8_Bounds(1u, 0u);
  return bounds;
}

static const int voxc_r4_4_4_g8_UNDECIDED = 2; // No order: it cannot be told here.

// The order of the moment at which a coordinate passes a face and another moment, where
// (face - origin) * 1 - moment * direction has this sign.
int voxc_r4_4_4_g8_order_by_sign(const voxc_r4_4_4_g8_Ray ray, int axis, int sign_of_difference) {
  return ray.falls[axis] ? -sign_of_difference : sign_of_difference;
}

int voxc_r4_4_4_g8_compare_moment_exactly(const voxc_r4_4_4_g8_Ray ray, int axis, int face, uint moment) {
  uint one = asuint(1.0f);
  voxc_r4_4_4_g8_Sum difference = voxc_r4_4_4_g8_sum_of_products(uint4(asuint(float(face)),
      ray.given_origin[axis] ^ voxc_r4_4_4_g8_SIGN_BIT, moment ^ voxc_r4_4_4_g8_SIGN_BIT, 0u), uint4(one, one,
      ray.given_direction[axis], 0u));
  return voxc_r4_4_4_g8_order_by_sign(ray, axis, voxc_r4_4_4_g8_sign_of(difference));
}

// What is known of the order of two moments: that one is later or sooner, or, of neither, that they are the same.
int voxc_r4_4_4_g8_order_decided(const voxc_r4_4_4_g8_Ray ray, int axis, uint moment, bool later, bool sooner,
    bool is_exact) {
  // Devices may not keep a denormal moment.
  bool decided = (later || sooner || is_exact) && ray.plain && moment - 1u >= 0x7fffffu;
  return decided ? voxc_r4_4_4_g8_order_by_sign(ray, axis, later ? 1 : sooner ? -1 : 0) : voxc_r4_4_4_g8_UNDECIDED;
}

// The same by float32, whose distance and way are rounded once each.
int voxc_r4_4_4_g8_compare_moment_by_floats(const voxc_r4_4_4_g8_Ray ray, int axis, int face, uint moment) {
  float distance = float(face) - asfloat(ray.given_origin[axis]);
  float way = asfloat(moment) * asfloat(ray.given_direction[axis]);
  float bound = (abs(distance) + abs(way)) * voxc_r4_4_4_g8_ROUNDINGS;
  return voxc_r4_4_4_g8_order_decided(ray, axis, moment, distance - way > bound, distance - way < -bound, false);
}

int voxc_r4_4_4_g8_compare_moment(const voxc_r4_4_4_g8_Ray ray, int axis, int face, uint moment) {
  return voxc_r4_4_4_g8_compare_moment_by_floats(ray, axis, face, moment);
}

// Whether the ray enters the traversal's cell before a moment, -1, at it, 0, or after it, 1. UNDECIDED if only exact
// arithmetic can tell, and that is not at hand, or the device has cut it short.
int voxc_r4_4_4_g8_compare_entry(const voxc_r4_4_4_g8_Ray ray, const voxc_r4_4_4_g8_Traversal traversal, uint moment) {
  if (traversal.axis < 0)
    return moment == 0u ? 0 : -1;
  int face = voxc_r4_4_4_g8_entered_face(ray, traversal);
  int order = voxc_r4_4_4_g8_compare_moment(ray, traversal.axis, face, moment);
  if (order == voxc_r4_4_4_g8_UNDECIDED)
    order = voxc_r4_4_4_g8_compare_moment_exactly(ray, traversal.axis, face, moment);
  return order;
}

// Where the entry of the traversal's cell lies: before the bounds, -1, within them, 0, or after them, 1. UNDECIDED as
// above.
int voxc_r4_4_4_g8_place_of_entry(const voxc_r4_4_4_g8_Ray ray, const voxc_r4_4_4_g8_Traversal traversal,
    const voxc_r4_4_4_g8_Bounds bounds) {
  int order;
  if (bounds.tmin == 0u)
    order = 0;
  else
    order = voxc_r4_4_4_g8_compare_entry(ray, traversal, bounds.tmin);
  if (order < 0 || order == voxc_r4_4_4_g8_UNDECIDED)
    return order;
  if (bounds.tmax == voxc_r4_4_4_g8_INFINITY_BITS)
    return 0;
  return max(voxc_r4_4_4_g8_compare_entry(ray, traversal, bounds.tmax), 0);
}

// Where a ray is at a moment, wrong by less than `wrong` and a rounding of it.
struct voxc_r4_4_4_g8_Place {
  float3 at;
  float3 wrong;
  bool is_known; // It is not out of float32's reach.
};

voxc_r4_4_4_g8_Place make_voxc_r4_4_4_g8_Place(float3 at, float3 wrong, bool is_known) {
  voxc_r4_4_4_g8_Place made;
  made.at = at;
  made.wrong = wrong;
  made.is_known = is_known;
  return made;
}

// From any distance, as rays come near (near.glsl): with halves of 12 bits no product is rounded, and their sum with
// the origin is kept as two float32, of which the lower one loses less than 2^-43 of the way and the distance. Where
// rays do not come near, as nearly all begin there, or as a language has no `precise`, it is one float32.
voxc_r4_4_4_g8_Place voxc_r4_4_4_g8_place_at(const voxc_r4_4_4_g8_Ray ray, uint moment) {
  const uint UPPER = 0xfffff000u; // The bits of a float32 but the lowest 12 of its significand.
  float3 origin = asfloat(ray.given_origin);
  float3 direction = asfloat(ray.given_direction);
  float t = asfloat(moment);
  float3 way = t * direction;
  float3 reach = abs(origin) + abs(way);
  bool is_known = all(reach < (float3)voxc_r4_4_4_g8_NEVER);
  float3 upper = asfloat(ray.given_direction & UPPER);
  float early = asfloat(moment & UPPER);
  float3 high = origin, low = (float3)0.0f;
  voxc_r4_4_4_g8_move_by(early * upper, high, low);
  voxc_r4_4_4_g8_move_by(early * (direction - upper), high, low);
  voxc_r4_4_4_g8_move_by((t - early) * upper, high, low);
  voxc_r4_4_4_g8_move_by((t - early) * (direction - upper), high, low);
  return make_voxc_r4_4_4_g8_Place(high + low, reach / 1099511627776.0f, is_known); // 2^40.
}

// Moves a traversal that begins long before a moment to a cell that the ray comes to shortly before.
void voxc_r4_4_4_g8_skip_to(const voxc_r4_4_4_g8_Ray ray, inout voxc_r4_4_4_g8_Traversal traversal, uint moment) {
  const int WORTH_SKIPPING = 4; // In voxels.
  if (moment == 0u || !voxc_r4_4_4_g8_is_in_volume(traversal.cell))
    return;
  uint3 size = ray.given_direction & ~voxc_r4_4_4_g8_SIGN_BIT;
  int axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
  voxc_r4_4_4_g8_Place place = voxc_r4_4_4_g8_place_at(ray, moment);
  if (!place.is_known)
    return;
  // By more than a few roundings.
  float before = place.at[axis] - float(ray.heading[axis]) * (2.0f + place.wrong[axis]);
  int face = int(floor(clamp(before, -1.0f, float(voxc_r4_4_4_g8_VOLUME_SIZE[axis] + 1))));
  int behind = face - int(ray.falls[axis]);
  if ((behind - traversal.cell[axis]) * ray.heading[axis] > WORTH_SKIPPING)
    traversal = voxc_r4_4_4_g8_behind_face(ray, traversal, traversal.cell, axis, face);
}

// Lets a traversal end shortly after a moment, where float32 can decide when that is.
void voxc_r4_4_4_g8_end_after(const voxc_r4_4_4_g8_Ray ray, inout voxc_r4_4_4_g8_Traversal traversal, uint moment) {
  if (!ray.plain || moment >= voxc_r4_4_4_g8_INFINITY_BITS || (moment != 0u && moment < 0x800000u))
    return;
  voxc_r4_4_4_g8_Place place = voxc_r4_4_4_g8_place_at(ray, moment);
  if (!place.is_known)
    return;
  float3 after = place.at + float3(ray.heading) * (2.0f + place.wrong);
  int3 last = int3(clamp(floor(after), (float3)0.0f, float3(voxc_r4_4_4_g8_VOLUME_SIZE - 1)));
  traversal.begin = voxc_r4_4_4_g8_mix((int3)0, last, ray.falls);
  traversal.size = voxc_r4_4_4_g8_mix(voxc_r4_4_4_g8_VOLUME_SIZE, last + 1, ray.heading > (int3)0) - traversal.begin;
}

// Lets a traversal that is ready end shortly after its bounds. False, and a miss, if nothing lies between them.
bool voxc_r4_4_4_g8_bound_traversal(const voxc_r4_4_4_g8_Ray ray, inout voxc_r4_4_4_g8_Traversal traversal,
    const voxc_r4_4_4_g8_Bounds bounds) {
  if (bounds.tmin > bounds.tmax) {
    traversal.cell = (int3)-1;
    traversal.pending_step = voxc_r4_4_4_g8_NO_PENDING_STEP;
    return false;
  }
  voxc_r4_4_4_g8_end_after(ray, traversal, bounds.tmax);
  return true;
}

// Goes on with a traversal to the first voxel that the ray enters within the bounds. A traversal of which that cannot
// be told stays where it is, in that voxel; one that has come beyond the bounds ends.
bool voxc_r4_4_4_g8_traverse_within(VOXC_VOLUME volume, const voxc_r4_4_4_g8_Ray ray,
    inout voxc_r4_4_4_g8_Traversal traversal, uint root, const voxc_r4_4_4_g8_Bounds bounds) {
  bool found = false;
  int place = -1;
  while (place < 0) {
    found = voxc_r4_4_4_g8_is_in_volume(traversal.cell) || traversal.pending_step >= 0;
    if (found)
      found = voxc_r4_4_4_g8_continue_traversal(volume, ray, traversal, root);
    if (found)
      place = voxc_r4_4_4_g8_place_of_entry(ray, traversal, bounds);
    else
      place = 0;
    if (place < 0)
      voxc_r4_4_4_g8_step_over_voxel(ray, traversal);
  }
  if (found && place == 1)
    traversal.cell = (int3)-1;
  return found && place == 0;
}

// What rays find, as it is told outside.

// A voxel on a ray. A miss is -1, -1, -1, 0, 0, -1, 0.
struct voxc_r4_4_4_g8_Hit {
  int3 voxel;
  float t;     // When the ray enters it, rounded to nearest; 0 where the ray begins in it.
  uint colour; // Its word: R in the lowest byte, then G, B and A; or a label.
  // Of the face by which the ray enters, 0, 1, 2 for x, y, z; the first of several. -1 where the ray begins inside.
  int axis;
  int side;    // -1 where that is the voxel's low face, 1 where it is the high one; 0 where there is none.
};

voxc_r4_4_4_g8_Hit make_voxc_r4_4_4_g8_Hit(int3 voxel, float t, uint colour, int axis, int side) {
  voxc_r4_4_4_g8_Hit made;
  made.voxel = voxel;
  made.t = t;
  made.colour = colour;
  made.axis = axis;
  made.side = side;
  return made;
}

voxc_r4_4_4_g8_Hit voxc_r4_4_4_g8_miss() { return make_voxc_r4_4_4_g8_Hit((int3)-1, 0.0f, 0u, -1, 0); }

voxc_r4_4_4_g8_Hit voxc_r4_4_4_g8_hit_of(VOXC_VOLUME volume, const voxc_r4_4_4_g8_Ray ray,
    const voxc_r4_4_4_g8_Traversal traversal) {
  bool sure;
  voxc_r4_4_4_g8_Arrival arrival = voxc_r4_4_4_g8_arrival_at(ray, traversal, true, sure);
  bool inside = arrival.face == voxc_r4_4_4_g8_BEGINS_INSIDE;
  int axis = inside ? -1 : int(arrival.face >> 1);
  int side = inside ? 0 : (arrival.face & 1u) != 0u ? 1 : -1;
  return make_voxc_r4_4_4_g8_Hit(traversal.cell, asfloat(arrival.t), voxc_r4_4_4_g8_colour_of(volume, traversal), axis,
      side);
}

// The normal of the face by which the ray enters, out of the voxel; 0 where there is none.
float3 voxc_r4_4_4_g8_normal(const voxc_r4_4_4_g8_Hit hit) {
  return float3(int3((int3)hit.axis == int3(0, 1, 2)) * hit.side);
}

// Where the ray of a hit enters the voxel, just outside of it, and within its face: rays that go on from there begin in
// the cell before that face, and need no tmin to leave the voxel. In a voxel in which the ray begins, that is where it
// begins.
float3 voxc_r4_4_4_g8_outside(float3 origin, float3 direction, const voxc_r4_4_4_g8_Hit hit) {
  if (hit.axis < 0)
    return origin;
  float3 low = float3(hit.voxel);
  float3 high = low + 1.0f;
  float3 within = clamp(origin + hit.t * direction, low, high - high / 8388608.0f);
  float3 beyond = hit.side > 0 ? high : low - max(low, 1.0f) / 8388608.0f;
  return voxc_r4_4_4_g8_mix(within, beyond, (int3)hit.axis == int3(0, 1, 2));
}

// What is called from outside.

// Goes from the ray's begin, or from behind the traversal's voxel where it has one, to the next voxel within [tmin,
// tmax].
bool voxc_r4_4_4_g8_seek(VOXC_VOLUME volume, uint3 origin, uint3 direction, float tmin, float tmax,
    out voxc_r4_4_4_g8_Ray ray, inout voxc_r4_4_4_g8_Traversal traversal) {
  bool goes_past = voxc_r4_4_4_g8_is_in_volume(traversal.cell);
  voxc_r4_4_4_g8_Bounds bounds = voxc_r4_4_4_g8_bounds_between(asuint(tmin), asuint(tmax));
  uint root = voxc_r4_4_4_g8_load_word(volume, 0u); // Leads to level 1, unless the volume is empty.
  bool found;
  found = voxc_r4_4_4_g8_begin_traversal(origin, direction, root, ray, traversal);
  if (found)
    found = voxc_r4_4_4_g8_bound_traversal(ray, traversal, bounds);
  if (found) {
    if (goes_past)
      voxc_r4_4_4_g8_step_over_voxel(ray, traversal);
    else
      voxc_r4_4_4_g8_skip_to(ray, traversal, bounds.tmin);
    found = voxc_r4_4_4_g8_traverse_within(volume, ray, traversal, root, bounds);
  }
  return voxc_r4_4_4_g8_end_traversal(origin, direction, traversal, found);
}

// The first voxel that the ray enters at a t in [tmin, tmax], in exact arithmetic; a NaN is in no interval. The voxel
// in which the ray begins is entered at t = 0. So with a tmin above 0 a ray that starts in a solid does not see the
// voxels that it has entered by then, but the next, which it enters through a face that is hidden.
bool voxc_r4_4_4_g8_closest(VOXC_VOLUME volume, float3 origin, float3 direction, float tmin, float tmax,
    out voxc_r4_4_4_g8_Hit hit) {
  voxc_r4_4_4_g8_Ray ray;
  voxc_r4_4_4_g8_Traversal traversal = voxc_r4_4_4_g8_traversal_at((int3)-1);
  bool found = voxc_r4_4_4_g8_seek(volume, asuint(origin), asuint(direction), tmin, tmax, ray, traversal);
  hit = voxc_r4_4_4_g8_miss();
  if (found)
    hit = voxc_r4_4_4_g8_hit_of(volume, ray, traversal);
  return found;
}

// From a hit of this very ray to the next voxel on it, if that is entered at tmax or before. None is left out or comes
// twice, also where several are entered at one moment.
bool voxc_r4_4_4_g8_next(VOXC_VOLUME volume, float3 origin, float3 direction, float tmax,
    inout voxc_r4_4_4_g8_Hit hit) {
  voxc_r4_4_4_g8_Ray ray;
  voxc_r4_4_4_g8_Traversal traversal = voxc_r4_4_4_g8_traversal_at(hit.voxel);
  bool found;
  found = voxc_r4_4_4_g8_is_in_volume(hit.voxel);
  if (found)
    found = voxc_r4_4_4_g8_seek(volume, asuint(origin), asuint(direction), 0.0f, tmax, ray, traversal);
  hit = voxc_r4_4_4_g8_miss();
  if (found)
    hit = voxc_r4_4_4_g8_hit_of(volume, ray, traversal);
  return found;
}

// Whether there is a voxel that the ray enters at a t in [tmin, tmax].
bool voxc_r4_4_4_g8_any(VOXC_VOLUME volume, float3 origin, float3 direction, float tmin, float tmax) {
  voxc_r4_4_4_g8_Ray ray;
  voxc_r4_4_4_g8_Traversal traversal = voxc_r4_4_4_g8_traversal_at((int3)-1);
  return voxc_r4_4_4_g8_seek(volume, asuint(origin), asuint(direction), tmin, tmax, ray, traversal);
}

#undef VOXC_INDEX
#endif
