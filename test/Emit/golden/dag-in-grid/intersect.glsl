#version 460
// intersect.glsl: first hits of rays with volumes of the format R(4, 4, 4) G(8).
// The digest of its storage is 0xa67ebecd25ab0065, and that of a volume must be the same.
// Before a function that is seldom called: kernels in C++ keep it out of the loops, into which all others go.
#define OUT_OF_LINE

// A host that wants workgroups of another size says so.
layout(local_size_x = 64, local_size_x_id = 7) in;

// A ray, prepared for the traversal. Its members that are no integers are approximate; what must be exact is asked of
// the ray as given.
struct Ray {
  uvec3 given_origin;     // The bits of six float32 taken as exact numbers.
  uvec3 given_direction;
  vec3 origin;            // Where the traversal counts from: the given origin, or where a ray from far away enters.
  // Scaled so that the longest component is in [1, 2). Where a coordinate never changes it is LEAST_COMPONENT: that
  // passes no face before another does. All t are those of this direction, from this origin.
  vec3 direction;
  vec3 inverse;
  vec3 late;              // By how much each t comes late that is counted from there.
  float t_error;          // Absolute error bound of t, apart from a few rounding errors.
  vec3 origin_low;        // The least that is certain of the coordinates at the origin,
  float coordinate_error; // and how much more any coordinate on the way may be, in voxels.
  float cell_margin;      // A coordinate that is at least this far below the next whole number is in its cell.
  bvec3 moves;            // False on an axis whose coordinate never changes.
  bvec3 falls;            // The coordinate falls.
  ivec3 heading;          // -1 where the coordinate falls, else 1.
  // From a face that the ray passes to the cell behind it: -1 where the coordinate falls, else 0.
  vec3 beyond;
  ivec3 ahead;            // No bits where the coordinate falls, else all: picks the face of a cube that lies ahead.
};

// Empty cubes of 2^log2_side voxels a side: the one around a cell and, `count` a side, those that lie ahead of it.
struct EmptySpan {
  int log2_side;
  int count;
};

// Where a ray is: the first cell not yet proved empty. Each step moves it by at least one cell, and never back.
struct Traversal {
  ivec3 cell;       // In voxels; outside the volume before and after the traversal.
  int axis;         // The axis on which the ray entered the cell; -1 where it started.
  uint voxel;       // Where the voxel that was hit is to be had, as the lowest level finds it.
  uint lookups;
  int steps_left;   // There are no more cells on any ray; a traversal with less than 0 is an error of the kernel's.
  // A step over an empty span around ~cell is pending: 32 times its count, and its log2_side. Else NO_PENDING_STEP.
  int pending_step;
};

// What follows behind the format.
uint load_word(uint place);
void count_lookup(inout Traversal traversal);
bool goes_on(const Traversal traversal);
void step_over(const Ray ray, inout Traversal traversal, const EmptySpan span, vec3 face);
void step_over(const Ray ray, inout Traversal traversal, const EmptySpan span);
void step_over(const Ray ray, inout Traversal traversal, int log2_side);
bool intersect_voxel(inout Traversal traversal, uint voxel);

// ---- The format: R(4, 4, 4) G(8) ----

// Which child of a node a place lies in, counted in children.
int child_index(ivec3 place) {
  ivec3 bits = place & 1;
  return bits.x | bits.y << 1 | bits.z << 2;
}

// Level 2: svdag, 256 x 256 x 256 cells of 1 voxel a side.
const int LEVEL_2_DEPTH = 8;
const int LEVEL_2_LOG2_CELL = 0;
const int LEVEL_2_LOG2_SIDE = 8;

// A node is [masks, slots of its children...]: a bit for each child that is not empty, one for each that is a leaf, and
// slots of those that are not empty or, where all leaves have one value, that are neither empty nor leaves. Gives the
// child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
uint child_level_2(uint node, ivec3 cell, int height, out bool leaf) {
  int child = child_index(cell >> height);
  uint masks = load_word(node);
  leaf = (masks >> (8 + child) & 1u) != 0u;
  if ((masks >> child & 1u) == 0u)
    return 0u;
  return load_word(node + 1u + uint(bitCount(masks & ((1u << child) - 1u))));
}

// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
// old cell and the new.
bool intersect_level_2(const Ray ray, inout Traversal traversal, uint root) {
  uint path[LEVEL_2_DEPTH + 1];
  path[LEVEL_2_DEPTH] = root;
  int top = LEVEL_2_DEPTH;
  for (;;) {
    // Down to the leaf, or the empty child, `layer` layers above the cells.
    count_lookup(traversal);
    ivec3 cell = traversal.cell >> LEVEL_2_LOG2_CELL;
    uint node = path[top];
    int layer = top;
    bool leaf = false;
    while (node != 0u && !leaf) {
      path[layer] = node;
      layer--;
      node = child_level_2(node, cell, layer, leaf);
    }
    ivec3 before = traversal.cell;
    if (node == 0u)
      step_over(ray, traversal, LEVEL_2_LOG2_CELL + layer);
    else if (leaf && intersect_voxel(traversal, node))
      return true;
    ivec3 changed = before ^ traversal.cell;
    int highest = findMSB(uint(changed.x | changed.y | changed.z));
    if (highest >= LEVEL_2_LOG2_SIDE)
      return false;
    top = max(layer, highest - LEVEL_2_LOG2_CELL) + 1;
  }
}

// Level 1: raw, 16 x 16 x 16 cells of 256 voxels a side.
const ivec3 LEVEL_1_LOG2_SIZE = ivec3(4, 4, 4);
const int LEVEL_1_LOG2_CELL = 8;

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
uint slot_level_1(uint grid, ivec3 cell) {
  ivec3 at = cell;
  return grid + uint(at.x + ((at.y + (at.z << LEVEL_1_LOG2_SIZE.y)) << LEVEL_1_LOG2_SIZE.x));
}

// The value of a cell, or 0 if it is empty.
uint cell_level_1(uint grid, ivec3 cell) {
  uint slot = slot_level_1(grid, cell);
  return load_word(slot);
}

bool intersect_level_1(const Ray ray, inout Traversal traversal, uint grid) {
  while (goes_on(traversal)) {
    count_lookup(traversal);
    EmptySpan span = EmptySpan(LEVEL_1_LOG2_CELL, 1);
    uint value = cell_level_1(grid, traversal.cell >> LEVEL_1_LOG2_CELL);
    if (value == 0u) {
      step_over(ray, traversal, span);
    } else if (intersect_level_2(ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
uint colour_of(const Traversal traversal) { return load_word(traversal.voxel); }

// ---- What follows is the same in every kernel ----

// Voxels along each axis.
const ivec3 VOLUME_SIZE = ivec3(4096, 4096, 4096);

// Count the lookups of each ray; off, it costs nothing.
layout(constant_id = 0) const bool COUNT_LOOKUPS = false;
// Count the words that each ray reads, and store that in place of its lookups; off, it costs nothing.
layout(constant_id = 2) const bool COUNT_WORDS = false;
uint words_read = 0u;
// Six words a ray without: origin, direction.
layout(std430, set = 0, binding = 0) readonly restrict buffer Rays { uvec2 ray_pairs[]; };
// Six words a hit: voxel, rgba, t, and lookups or words read, else a face.
layout(std430, set = 0, binding = 1) restrict buffer Hits { uvec2 hit_pairs[]; };
// A dispatch without the exact fallback defers the rays that need exact arithmetic to one with it, over these alone:
// what that is started with, how many they are, and their numbers.
layout(std430, set = 0,
    binding = 3) restrict buffer Deferred { uint deferred_groups[3]; uint deferred_count; uint deferred_rays[]; };
layout(constant_id = 3) const bool EXACT_FALLBACK = true;
// Rays that begin far away are moved near the volume; off, where none does, it costs nothing, and those that do are
// resolved exactly.
layout(constant_id = 6) const bool COMES_NEAR = true;
// The rays of this dispatch; a `task` other than all of them, from their beginning, goes on with rays that were
// deferred.
layout(push_constant) uniform Tile { uint first_ray; uint ray_count; uint task; };
const uint ALL = 0u;
const uint DEFERRED = 1u; // Those of the list.
const uint TRUNCATED = 2u; // Those that are unfinished.

// The volume's words lie in one storage buffer.
layout(std430, set = 0, binding = 2) readonly restrict buffer Words { uint words[]; };

uint load_word(uint place) {
  if (COUNT_WORDS)
    words_read++;
  return words[place];
}

// How a ray leaves cells through the faces ahead.
struct Exit {
  float t;      // About when.
  bvec3 passed; // The axes whose faces it passes.
  bool sure;    // It is known to pass that one first.
};

const int NO_PENDING_STEP = -1;
const int RETRY = -2; // The traversal is to be gone on with, from its cell, by the exact fallback.

const float NEVER = 1e30f; // A t that no ray of an ordinary length comes to.

// What is rounded on the way to a t, which is a difference, an inverse and a product. Where devices round to nearest,
// eight roundings: the order of two t is certain beyond 7 roundings of the earlier, and a coordinate within 7 of how
// far it may be from the origin. Else twelve roundings of 2^-23, whichever way each goes: an inverse takes 2.5 of them,
// the order of two t is certain beyond 11, and a coordinate within 9.5.
const float ROUNDINGS = 12.0f / 8388608.0f;

// A traversal that is about to begin, or to go on.
Traversal traversal_at(ivec3 cell) {
  int most_steps = VOLUME_SIZE.x + VOLUME_SIZE.y + VOLUME_SIZE.z;
  return Traversal(cell, -1, 0u, 0u, most_steps, NO_PENDING_STEP);
}

// Ends a traversal that takes more steps than any can.
void count_step(inout Traversal traversal) {
  traversal.steps_left--;
  traversal.cell.x |= traversal.steps_left >> 31; // All bits: outside, whatever follows.
}

void count_lookup(inout Traversal traversal) {
  if (COUNT_LOOKUPS)
    traversal.lookups++;
}

bool is_in_volume(ivec3 cell) { return all(lessThan(uvec3(cell), uvec3(VOLUME_SIZE))); }

// Whether a traversal has more to see here.
bool goes_on(const Traversal traversal) { return is_in_volume(traversal.cell); }

// The low corner of the aligned cube of 2^log2_side voxels a side around a cell.
ivec3 corner_of(ivec3 cell, int log2_side) { return (cell >> log2_side) << log2_side; }

// The low corner of the cube of an empty span around a cell.
ivec3 corner_of(const Ray ray, ivec3 cell, const EmptySpan span) {
  return corner_of(cell, span.log2_side) - (~ray.ahead & ((span.count - 1) << span.log2_side));
}

// The faces of an empty span around a cell that lie ahead.
ivec3 faces_ahead(const Ray ray, ivec3 cell, const EmptySpan span) {
  int side = 1 << span.log2_side;
  // From the cube's low face to that of the empty span, where the coordinate falls.
  int back = side - (span.count << span.log2_side);
  return (cell & -side) + back + (ray.ahead & (side - back - back));
}

// About when each coordinate passes its face.
vec3 times_of(const Ray ray, vec3 face) {
  vec3 t = (face - ray.origin) * ray.inverse;
  return COMES_NEAR ? t - ray.late : t;
}

// The order of float32 numbers by their bits is one instruction where others would look for NaN. Negative ones are
// below all others, but of two of them the order is the other one: no t of a face ahead is negative but by rounding.

float least_of(vec3 of) {
  ivec3 bits = floatBitsToInt(of);
  return intBitsToFloat(min(min(bits.x, bits.y), bits.z));
}

float second_least_of(vec3 of) {
  ivec3 bits = floatBitsToInt(of);
  return intBitsToFloat(max(min(bits.x, bits.y), min(max(bits.x, bits.y), bits.z)));
}

float greatest_of(vec3 of) {
  ivec3 bits = floatBitsToInt(of);
  return intBitsToFloat(max(max(bits.x, bits.y), bits.z));
}

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

// 2^exponent, for exponents of normal numbers; the nearest such for others.
float power_of_two(int exponent) { return uintBitsToFloat(uint(clamp(exponent, -126, 127) + 127) << 23); }

// The bits of the longest component's magnitude.
uint longest_of(uvec3 direction) {
  uvec3 size = direction & ~SIGN_BIT;
  return max(max(size.x, size.y), size.z);
}

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

// The moments at which a ray changes cell, in exact order. Cells are half-open, so where several coordinates pass a
// face at one t, rising ones change cell first, falling ones just after.

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
  return sum_of_products(uvec4(floatBitsToUint(at_a), ray.given_origin[a] ^ SIGN_BIT, floatBitsToUint(at_b) ^ SIGN_BIT,
      ray.given_origin[b]), uvec4(speed_b, speed_b, speed_a, speed_a));
}

const int CUT_SHORT = 2; // No order: the device did not let it be found.

// -1 if coordinate a passes its face first, 0 if both pass theirs at the same t, else 1. Both move.
OUT_OF_LINE int compare_exactly(const Ray ray, int a, int face_a, int b, int face_b) {
  Sum difference = crossing_difference(ray, a, float(face_a), b, float(face_b));
  int order = sign_of(difference);
  order = difference.complete ? order : CUT_SHORT;
  return order == CUT_SHORT || ray.falls[a] == ray.falls[b] ? order : -order;
}

// The same, by doubles where they can decide.
int compare_crossings(const Ray ray, int a, int face_a, int b, int face_b) {
  return compare_exactly(ray, a, face_a, b, face_b);
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
OUT_OF_LINE ivec3 resolve_cell(const Ray ray, const Crossing crossing, const Range candidates) {
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
  vec3 point = ray.origin_low + crossing.t * ray.direction;
  vec3 bound = mix(vec3(0.0f), vec3(ray.coordinate_error), ray.moves);
  vec3 least = vec3(range.least);
  vec3 most = vec3(range.most);
  return Range(ivec3(clamp(floor(point), least, most)), ivec3(clamp(floor(point + bound), least, most)));
}

// Steps that are exact for every ray: by float32 or doubles where these can decide, by integers elsewhere.

// How the ray leaves cells through the first of the faces ahead. Not sure if its t cannot decide which that is.
Exit leave(const Ray ray, vec3 face) {
  vec3 t = times_of(ray, face);
  float first = least_of(t);
  float second = second_least_of(t); // Of negative ones, none that is sure.
  return Exit(first, equal(t, vec3(first)), second > first + (first * ROUNDINGS + ray.t_error));
}

// The cell that a ray comes to where it leaves others, of which `cell` is one, by one of the faces ahead. Not sure if
// its point cannot decide on which side of another face that is.
ivec3 cell_beyond(const Ray ray, vec3 face, inout Exit leaving) {
  vec3 point = mix(ray.origin_low + leaving.t * ray.direction, face + ray.beyond, leaving.passed);
  vec3 whole = floor(point);
  bool is_certain = greatest_of(point - whole) < ray.cell_margin;
  leaving.sure = leaving.sure && is_certain;
  return ivec3(whole);
}

// Resolves the step over the empty span around the traversal's cell: which faces the ray passes first, of those that
// float32 cannot decide apart, and then by bisection to which cell it comes. All questions are asked at one place,
// since devices of wide vectors run through it as often as any ray needs it. Where the device cuts it short, the
// traversal stays where it is.
OUT_OF_LINE Traversal exact_step(const Ray ray, Traversal traversal, const EmptySpan span) {
  int side = span.count << span.log2_side;
  ivec3 corner = corner_of(ray, traversal.cell, span);
  ivec3 face = corner + (ray.ahead & side);
  vec3 t = times_of(ray, vec3(face));
  float earliest = min(min(t.x, t.y), t.z);
  bvec3 may_be_first = lessThanEqual(t, vec3(earliest + (earliest * ROUNDINGS + ray.t_error)));
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
    traversal.cell = range.least;
    traversal.axis = crossing.axis;
  }
  return traversal;
}

// Resolves the step of a traversal that is pending.
void resolve_step(const Ray ray, inout Traversal traversal) {
  EmptySpan span = EmptySpan(traversal.pending_step & 31, traversal.pending_step >> 5);
  traversal.pending_step = NO_PENDING_STEP;
  traversal.cell = ~traversal.cell;
  traversal = exact_step(ray, traversal, span);
}

// Steps from one cell of the ray to the next.

// Ends a step over the empty span around the traversal's cell, or over that and more, which leads to another cell if
// that is sure.
void end_step(inout Traversal traversal, const Exit leaving, ivec3 cell, const EmptySpan span) {
  traversal.axis = leaving.passed.z ? 2 : leaving.passed.y ? 1 : 0;
  bool sure = leaving.sure;
  // A step that is not sure is left pending, and all loops end: what resolves it stands outside of them, where lanes
  // that are sure need not wait for it.
  // The next turn may read what is there before it is known if the step is sure.
  traversal.cell = sure ? cell : ~traversal.cell;
  traversal.pending_step = sure ? NO_PENDING_STEP : span.count << 5 | span.log2_side;
  count_step(traversal);
}

// Steps over the empty span around the traversal's cell, of which these faces lie ahead.
void step_over(const Ray ray, inout Traversal traversal, const EmptySpan span, vec3 face) {
  Exit leaving = leave(ray, face);
  ivec3 cell = cell_beyond(ray, face, leaving);
  end_step(traversal, leaving, cell, span);
}

// Steps over the empty span around the traversal's cell.
void step_over(const Ray ray, inout Traversal traversal, const EmptySpan span) {
  step_over(ray, traversal, span, vec3(faces_ahead(ray, traversal.cell, span)));
}

// Steps over the empty cube of 2^log2_side voxels a side around the traversal's cell.
void step_over(const Ray ray, inout Traversal traversal, int log2_side) {
  step_over(ray, traversal, EmptySpan(log2_side, 1));
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
float far_away() {
  int side = max(max(VOLUME_SIZE.x, VOLUME_SIZE.y), VOLUME_SIZE.z);
  // In doubles, of a component that was raised to LEAST_COMPONENT, a t that is not larger makes less than one rounding.
  return float(2 * side);
}

// What is known of a ray that may have been moved.
struct Start {
  bool is_far;   // It still begins far away, and float32 tells nothing of it.
  float wrong;   // What may be wrong of its coordinates, beside a few roundings,
  float t_error; // and of a t.
};

bool is_far(vec3 coordinate, bvec3 moves) {
  return any(greaterThan(abs(coordinate), mix(vec3(NEVER), vec3(far_away()), moves)));
}

// Moves coordinates. Those in float32 are sums of two: what the first sum loses is added to the second. Doubles lose
// one rounding of 2^-53.
void move_by(vec3 way, inout vec3 high, inout vec3 low) {
  precise vec3 sum = high + way;
  precise vec3 of_way = sum - high;
  precise vec3 of_high = sum - of_way;
  precise vec3 lost = (high - of_high) + (way - of_way);
  high = sum;
  low += lost;
}

// Moves a ray that begins far away, to before the last of the faces by which it enters the volume. Once is enough up to
// a thousand times that distance.
Start come_near(inout Ray ray, vec3 face) {
  const uint UPPER = 0xfffff000u; // The bits of a float32 but the lowest 12 of its significand.
  const int MOST_MOVES = 3;
  // No ordinary ray is, if none comes near.
  Start start = Start((COMES_NEAR || EXACT_FALLBACK) && is_far(ray.origin, ray.moves), 0.0f, 0.0f);
  if (!COMES_NEAR || !start.is_far)
    return start;
  vec3 direction = mix(vec3(0.0f), ray.direction, ray.moves);
  const float LAST = 18446744073709551616.0f; // 2^64, at least as many voxels away.
  vec3 upper = uintBitsToFloat(floatBitsToUint(direction) & UPPER);
  vec3 high = ray.origin, low = vec3(0.0f);
  float latest = 0.0f;
  for (int moves = 0; moves < MOST_MOVES && start.is_far; moves++) {
    vec3 t = mix(vec3(-NEVER), (face - high) * ray.inverse, ray.moves);
    latest = max(max(t.x, t.y), t.z);
    bool is_ahead = latest > 0.0f && latest < LAST;
    float moment = is_ahead ? uintBitsToFloat(floatBitsToUint(latest * (1.0f - 1.0f / 1048576.0f)) & UPPER) : 0.0f;
    start.wrong += (4.0f * moment + far_away()) / 8796093022208.0f; // 2^43.
    move_by(moment * upper, high, low);
    move_by(moment * (direction - upper), high, low);
    latest -= moment;
    start.is_far = is_far(high, ray.moves);
  }
  precise vec3 whole = high + low;
  precise vec3 behind = low - (whole - high);
  ray.origin = start.is_far ? ray.origin : whole;
  ray.late = start.is_far ? ray.late : mix(vec3(0.0f), behind * ray.inverse, ray.moves);
  vec3 steep = abs(ray.inverse);
  // A t is rounded once more by what comes late, and none in the volume is above that of its last entry and the longest
  // side, which is half of what is far.
  steep = mix(vec3(0.0f), steep, ray.moves);
  start.t_error = 2.0f * start.wrong * max(max(steep.x, steep.y),
      steep.z) + (latest + 0.5f * far_away()) * ROUNDINGS / 4.0f;
  start.wrong += far_away() / 4194304.0f; // What is behind, and that rounding.
  return start;
}

// Where a traversal begins: in the cell of the ray's origin, or in the first cell of the volume that the ray comes to.

const float CLOSE = 1.0f / 2048.0f; // In voxels.

// Bounds what float32 gets wrong in a traversal through the volume, where the origin itself is wrong by `of_origin`,
// and a t by `t_error`. A coordinate that never changes stays in its cell.
void bound_errors(inout Ray ray, vec3 cell, float of_origin, float t_error) {
  vec3 half_size = 0.5f * vec3(VOLUME_SIZE);
  vec3 reach = abs(ray.origin - half_size) + half_size; // To the farther of the volume's two faces.
  float error = greatest_of(reach) * ROUNDINGS + of_origin;
  if (COMES_NEAR || EXACT_FALLBACK)
    error = min(error + 2.0f * t_error, NEVER);
  ray.t_error = t_error;
  ray.origin_low = mix(cell + 0.25f, ray.origin - error, ray.moves);
  ray.coordinate_error = 2.0f * error;
  ray.cell_margin = 1.0f - ray.coordinate_error;
}

// True where the ray moves from a coordinate so close to 0 that it may pass that face before float32 says so, as scaled
// directions have no component below 2^-60.
bvec3 starts_tiny(const Ray ray) {
  const uint TINY_BITS = 0x30800000u; // Of 2^-30.
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
  float error = 0.0f;
  for (int other = 0; other < 3; other++) {
    if (other == axis) {
      ray.origin[other] = float(face);
    } else if (ray.moves[other]) {
      ray.origin[other] = coordinate_at(ray, axis, face, other);
      error = max(error, CLOSE + CLOSE * abs(ray.origin[other]) / 256.0f); // More than a few roundings.
    }
  }
  vec3 steep = mix(vec3(0.0f), abs(ray.inverse), ray.moves);
  ray.late = vec3(0.0f);
  bound_errors(ray, vec3(cell), error, 2.0f * error * max(max(steep.x, steep.y), steep.z));
}

// Puts a traversal into the cell that the ray comes to where it passes a face, in exact arithmetic. `cell` tells the
// coordinates that never change.
Traversal behind_face(const Ray ray, Traversal traversal, ivec3 cell, int axis, int face) {
  Crossing crossing;
  crossing.t = (float(face) - ray.origin[axis]) * ray.inverse[axis] - ray.late[axis];
  crossing.axis = axis;
  crossing.face = face;
  crossing.rising = !ray.falls[axis];
  Range range = Range(mix(cell, ivec3(-1), ray.moves), mix(cell, VOLUME_SIZE, ray.moves));
  range.most[axis] = face - (ray.falls[axis] ? 1 : 0);
  range.least[axis] = range.most[axis];
  traversal.cell = resolve_cell(ray, crossing, approximate_cell(ray, crossing, range));
  traversal.axis = axis;
  return traversal;
}

// Finds the cell in which the ray enters the volume, in exact arithmetic: that of its origin, or through the last of
// the faces that it must pass. A cell outside if there is none.
OUT_OF_LINE Traversal entered_exactly(inout Ray ray, Traversal traversal, bool starts_far) {
  ivec3 cell = floor_of(ray.given_origin);
  ivec3 below = ivec3(lessThan(cell, ivec3(0)));
  ivec3 above = ivec3(greaterThanEqual(cell, VOLUME_SIZE));
  ivec3 enters = below * (ivec3(ray.moves) - ivec3(ray.falls)) + above * ivec3(ray.falls);
  traversal.cell = cell;
  if (enters == ivec3(0) || enters != below + above)
    return traversal;
  ivec3 face = mix(ivec3(0), VOLUME_SIZE, ray.falls);
  int axis = last_entered(ray, greaterThan(enters, ivec3(0)), face);
  if (starts_far)
    start_at(ray, cell, axis, face[axis]);
  return behind_face(ray, traversal, cell, axis, face[axis]);
}

// The same by float32 or doubles, of an ordinary ray: it passes the last of these faces, or is past all of them. Not
// sure if that cannot decide which face is the last, or which cell is behind it.
Traversal entered(const Ray ray, Traversal traversal, vec3 face, inout bool sure) {
  // 2^48: a ray of a voxel a moment is past the volume by then, whatever enters last.
  const float LATEST = 281474976710656.0f;
  vec3 t = mix(vec3(-1.0f), times_of(ray, face), ray.moves); // A coordinate that never changes stays outside.
  bool is_as_given = ray.t_error == 0.0f; // Else it has come near, and does not begin here.
  // From a last face, which is not in the volume, a ray enters at 0; its t is a 0 with a sign.
  vec3 last_face = mix(vec3(NEVER), face, ray.falls);
  bvec3 on_face = equal(ray.origin, is_as_given ? last_face : vec3(NEVER));
  t = mix(t, vec3(0.0f), on_face);
  float latest = min(greatest_of(t), LATEST);
  float before = second_least_of(t);
  bvec3 passed = equal(t, vec3(latest));
  bool begins_here = !(latest > 0.0f) && is_as_given && !any(on_face);
  vec3 point = mix(ray.origin_low + latest * ray.direction, face + ray.beyond, passed);
  point = begins_here ? ray.origin : point;
  vec3 whole = floor(point);
  bool is_last = before < latest - (latest * ROUNDINGS + ray.t_error);
  bool is_certain = greatest_of(point - whole) < ray.cell_margin;
  bool is_sure = begins_here || (is_last && is_certain);
  sure = sure && is_sure;
  traversal.cell = ivec3(clamp(whole, -1.0f, 4194304.0f));
  traversal.axis = begins_here ? -1 : passed.x ? 0 : passed.y ? 1 : 2;
  return traversal;
}

// True if a coordinate is past the volume, and goes on.
bool leaves_volume(const Ray ray) {
  ivec3 below = ivec3(lessThan(ray.origin, vec3(0.0f)));
  ivec3 above = ivec3(greaterThanEqual(ray.origin, vec3(VOLUME_SIZE)));
  return mix(above, below, ray.falls) != ivec3(0);
}

// Puts the traversal into the first cell of the volume on the ray; false if there is none, or if the ray is left.
bool enter_volume(inout Ray ray, inout Traversal traversal, bool ordinary) {
  if (COMES_NEAR && ordinary && leaves_volume(ray))
    return false;
  vec3 face = mix(vec3(0.0f), vec3(VOLUME_SIZE), ray.falls);
  vec3 cell = floor(ray.origin);
  Start near = come_near(ray, face);
  if (EXACT_FALLBACK && !ordinary && any(starts_tiny(ray)))
    near.t_error = NEVER;
  bound_errors(ray, cell, near.wrong, near.t_error);
  bool has_begun = is_in_volume(traversal.cell) || traversal.pending_step >= 0;
  if (EXACT_FALLBACK && has_begun && !near.is_far)
    return true; // Where it has entered need not be found again.
  bool sure = ordinary && !near.is_far;
  Traversal start = entered(ray, traversal, face, sure);
  if (EXACT_FALLBACK && !sure) {
    Ray moved = ray; // What a function may change by reference stands in memory; the ray itself need not.
    start = entered_exactly(moved, traversal, near.is_far);
    ray = moved;
  }
  if (!EXACT_FALLBACK && !sure) {
    start = traversal;
    start.cell = ivec3(-1);
    start.pending_step = RETRY;
  }
  traversal = start;
  return is_in_volume(traversal.cell);
}

// A ray as given, made ready for the traversal.

const float LEAST_COMPONENT = 1.0f / 1099511627776.0f / 1099511627776.0f; // 2^-80.

// Most rays are ordinary: float32 traverses with them as they are, and nothing overflows or is lost on the way. Their
// direction is scaled without a rounding, all numbers of theirs are then 0 or at least 2^-80, and they begin within
// 2^45 voxels, or near the volume if rays from far away are not moved. `longest` has the bits of the direction's
// longest component, and `component` is the direction once it is scaled.
bool is_ordinary(uvec3 origin, uint longest, vec3 component) {
  const uint SHORTEST = 0x00800000u; // The bits of 2^-126, below which devices may keep no number.
  const uint RANGE = 0x7e800000u; // From there to 2^127, where no number is left to scale by.
  const uint FAR_BITS = 0x56000000u; // Of 2^45.
  uvec3 place = origin & ~SIGN_BIT;
  uvec3 least = min(place - 1u, floatBitsToUint(abs(component)));
  uint farthest = max(max(place.x, place.y), place.z);
  bool is_scaled = longest - SHORTEST < RANGE;
  bool is_large = min(min(least.x, least.y), least.z) >= floatBitsToUint(LEAST_COMPONENT);
  bool is_near = farthest < (COMES_NEAR ? FAR_BITS : floatBitsToUint(far_away()));
  return is_scaled && is_large && is_near;
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
    result[axis] = float(significand) * power_of_two(-findMSB(significand)) * power_of_two(max(exponent[axis] - largest,
        -60));
  }
  return result;
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
  if (EXACT_FALLBACK && !ordinary) {
    component = mix(vec3(1.0f), vec3(-1.0f), greaterThan(direction, uvec3(SIGN_BIT))) * scaled_exactly(size);
    component = mix(vec3(LEAST_COMPONENT), component, ray.moves);
  }
  ivec3 sign = floatBitsToInt(component) >> 31;
  ray.origin = uintBitsToFloat(origin);
  ray.direction = component;
  ray.inverse = 1.0f / ray.direction;
  ray.late = vec3(0.0f);
  ray.falls = lessThan(sign, ivec3(0));
  ray.heading = sign | 1;
  ray.beyond = vec3(sign);
  ray.ahead = ~sign;
  return ray;
}

// From a ray to its traversal, and the end of the traversal.

// A ray that goes nowhere can hit its own cell alone: it is let go anywhere, and takes no later hit.
bool goes_nowhere(uvec3 direction) { return ((direction.x | direction.y | direction.z) & ~SIGN_BIT) == 0u; }

// Makes a ray ready, and its traversal too, if that has not begun. False if there is nothing to go through, or if the
// ray is left.
bool begin_traversal(uvec3 origin, uvec3 direction, uint root, out Ray ray, inout Traversal traversal) {
  bool stays = EXACT_FALLBACK && goes_nowhere(direction);
  bool ordinary;
  ray = prepare_ray(origin, stays ? uvec3(floatBitsToUint(1.0f), 0u, 0u) : direction, ordinary);
  if (root == 0u)
    return false;
  if (EXACT_FALLBACK && !(are_finite(origin) && are_finite(direction)))
    return false;
  Traversal start = traversal;
  bool enters = enter_volume(ray, start, ordinary);
  bool may_have_begun = EXACT_FALLBACK; // A dispatch without the exact fallback begins all its rays.
  bool has_begun = may_have_begun && (is_in_volume(traversal.cell) || traversal.pending_step != NO_PENDING_STEP);
  if (!enters || !has_begun)
    traversal = start;
  return enters;
}

// What becomes of a hit: a ray that goes nowhere loses what is not in its own cell, once its traversal has begun.
bool end_traversal(uvec3 origin, uvec3 direction, inout Traversal traversal, bool hit) {
  bool may_stay = EXACT_FALLBACK; // Packets go on with rays that exact arithmetic has prepared.
  if (!may_stay || !goes_nowhere(direction) || traversal.pending_step == RETRY || traversal.cell == floor_of(origin))
    return hit;
  traversal.cell = ivec3(-1);
  traversal.pending_step = NO_PENDING_STEP;
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
    if (is_below(a, b))
      a = difference_of(b, a);
    else
      a = difference_of(a, b);
    // What fell off was to be taken away.
    if (distance.inexact)
      a = difference_of(a, Wide(0u, 1u));
  }
  int place = log2_of(a) - 49;
  distance.number = shifted(a, -place, distance.inexact);
  distance.exponent = top - 61 + place;
  return distance;
}

// value * 2^exponent of a value below 2^27, rounded to the nearest float32, ties to even; `inexact` if it is a little
// more.
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
  // The quotient, below 2^27, by an estimate that an exact remainder corrects: what float32 rounds leaves it wrong by
  // less than 100, so the remainder fits 32 bits; the quotient of that is wrong by 1 at most.
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

// The same, as fast as it can be told. Where a device promises little of its arithmetic, integers tell it of every hit:
// a dispatch that does not resolve would defer each of them to one with it.
uint crossing_time(const Ray ray, int axis, int face, out bool sure) {
  sure = false;
  uint bits = 0u;
  if (!sure) {
    bits = time_exactly(ray, axis, face);
    sure = true;
  }
  return bits;
}

// The face through which the ray entered its cell.
int entered_face(const Ray ray, const Traversal traversal) {
  return traversal.cell[traversal.axis] + (ray.falls[traversal.axis] ? 1 : 0);
}

// How a ray comes to the voxel that it hits.
struct Arrival {
  uint t; // The bits of a float32.
};

// How the ray came to the traversal's cell. Not sure where float32 or doubles cannot decide.
Arrival arrival_at(const Ray ray, const Traversal traversal, bool hit, out bool sure) {
  Arrival arrival;
  arrival.t = 0u;
  sure = true;
  if (!hit || traversal.axis < 0)
    return arrival;
  arrival.t = crossing_time(ray, traversal.axis, entered_face(ray, traversal), sure);
  return arrival;
}

// A single voxel: the traversal has arrived.
bool intersect_voxel(inout Traversal traversal, uint voxel) {
  traversal.voxel = voxel;
  return true;
}

// Goes on with a traversal to its end, or until it is left.
bool continue_traversal(const Ray ray, inout Traversal traversal, uint root) {
  if (!EXACT_FALLBACK)
    return is_in_volume(traversal.cell) && intersect_level_1(ray, traversal, root);
  bool hit = false;
  bool is_under_way = true;
  while (is_under_way) {
    while (traversal.pending_step >= 0)
      resolve_step(ray, traversal);
    // What was resolved may have been the last step inside.
    hit = is_in_volume(traversal.cell) && intersect_level_1(ray, traversal, root);
    is_under_way = traversal.pending_step >= 0;
  }
  return hit;
}

// Rays and hits in their buffers. `at` is where the words of a hit begin: six for each ray.

// What is stored of a ray: a hit, or where its traversal was left.
struct HitWords {
  uvec3 voxel;
  uint rgba;
  uint t;
  uint last; // Lookups or words read, else a face.
};

uvec3 load_origin(uint at) {
  uvec2 first = ray_pairs[at / 2u], second = ray_pairs[at / 2u + 1u];
  return uvec3(first, second.x);
}

uvec3 load_direction(uint at) {
  uvec2 second = ray_pairs[at / 2u + 1u], third = ray_pairs[at / 2u + 2u];
  return uvec3(second.y, third);
}

void store_hit(uint at, const HitWords hit) {
  hit_pairs[at / 2u] = hit.voxel.xy;
  hit_pairs[at / 2u + 1u] = uvec2(hit.voxel.z, hit.rgba);
  hit_pairs[at / 2u + 2u] = uvec2(hit.t, hit.last);
}

HitWords load_hit(uint at) {
  uvec2 first = hit_pairs[at / 2u], second = hit_pairs[at / 2u + 1u], third = hit_pairs[at / 2u + 2u];
  return HitWords(uvec3(first, second.x), second.y, third.x, third.y);
}

// From the buffers to a traversal, and back.

// Whether a traversal is where it may go on.
bool is_under_way(const Traversal traversal) {
  return is_in_volume(traversal.pending_step >= 0 ? ~traversal.cell : traversal.cell);
}

// The traversal of a ray that was left: -2 - cell in place of a voxel, what is open in place of its colour, its axis in
// place of t. One of -1 has not begun.
Traversal deferred_traversal(uint at) {
  HitWords left = load_hit(at);
  Traversal traversal = traversal_at(-2 - ivec3(left.voxel));
  traversal.axis = int(left.t);
  traversal.pending_step = max(int(left.rgba), NO_PENDING_STEP);
  traversal.cell = traversal.pending_step >= 0 ? ~traversal.cell : traversal.cell;
  words_read = is_under_way(traversal) ? left.last : 0u;
  traversal.lookups = words_read;
  return traversal;
}

HitWords words_of_deferred(const Traversal traversal) {
  ivec3 voxel = -2 - (traversal.pending_step >= 0 ? ~traversal.cell : traversal.cell);
  uint count = COUNT_WORDS ? words_read : traversal.lookups;
  return HitWords(uvec3(voxel), uint(traversal.pending_step), uint(traversal.axis), count);
}

// A hit is its voxel, if that is asked. A miss is -1. One that would not have ended is told by a cell far below.
HitWords words_of(const Traversal traversal, bool hit, const Arrival arrival) {
  HitWords words;
  words.voxel = uvec3(hit ? traversal.cell : ivec3(traversal.steps_left < 0 ? -0x7fffffff : -1));
  words.rgba = hit ? colour_of(traversal) : 0u;
  words.t = hit ? arrival.t : 0u;
  words.last = COUNT_WORDS ? words_read : traversal.lookups;
  return words;
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

// Traces a ray, from where it was deferred if it `goes_on`. True if it is deferred, again.
bool trace_ray(uint ray_number, bool goes_on) {
  uint at = 6u * ray_number;
  Traversal traversal = traversal_at(ivec3(-1));
  if (goes_on)
    traversal = deferred_traversal(at);
  uvec3 direction = load_direction(at);
  uint root = load_word(0u); // Leads to level 1, unless the volume is empty.
  Ray ray;
  bool hit = false;
  hit = begin_traversal(load_origin(at), direction, root, ray, traversal) && continue_traversal(ray, traversal, root);
  hit = end_traversal(load_origin(at), direction, traversal, hit);
  Arrival arrival;
  bool sure;
  arrival = arrival_at(ray, traversal, hit, sure);
  traversal.pending_step = sure ? traversal.pending_step : RETRY;
  // A traversal that is still inside the volume without a hit, or whose arrival may not be whole, was cut off by the
  // device.
  if (EXACT_FALLBACK && hit && !loops_are_whole())
    hit = false;
  bool is_deferred = traversal.pending_step != NO_PENDING_STEP;
  is_deferred = is_deferred || (!hit && is_in_volume(traversal.cell));
  HitWords words = words_of(traversal, hit, arrival);
  if (is_deferred)
    words = words_of_deferred(traversal);
  store_hit(at, words);
  return is_deferred;
}

// Puts a ray on the list of those that are deferred.
void defer(uint ray_number) {
  uint place = atomicAdd(deferred_count, 1u);
  deferred_rays[place] = ray_number;
  if (place % gl_WorkGroupSize.x == 0u)
    atomicAdd(deferred_groups[0], 1u);
}

void main() {
  uint number = gl_GlobalInvocationID.x;
  bool goes_on = EXACT_FALLBACK && task != ALL; // A dispatch without the exact fallback begins all its rays.
  bool is_listed = goes_on && task == DEFERRED;
  if (number >= (is_listed ? deferred_count : ray_count))
    return;
  uint ray_number = is_listed ? deferred_rays[number] : first_ray + number;
  if (goes_on && task == TRUNCATED && int(load_hit(6u * ray_number).voxel.x) > -2)
    return;
  if (trace_ray(ray_number, goes_on) && !EXACT_FALLBACK)
    defer(ray_number);
}
