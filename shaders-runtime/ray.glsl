// A ray, prepared for the traversal. Its members that are no integers are approximate; what must be exact is asked of the ray as given.
struct Ray {
  uvec3 given_origin; // The bits of six float32 taken as exact numbers.
  uvec3 given_direction;
  real3 origin; // Where the traversal counts from: the given origin, or where a ray from far away enters.
  // Scaled so that the longest component is in [1, 2). Where a coordinate never changes it is LEAST_COMPONENT: that passes no face
  // before another does. All t are those of this direction, from this origin.
  real3 direction;
  real3 inverse;
  real3 late;            // By how much each t comes late that is counted from there.
  real t_error;          // Absolute error bound of t, apart from a few rounding errors.
  real3 origin_low;      // The least that is certain of the coordinates at the origin,
  real coordinate_error; // and how much more any coordinate on the way may be, in voxels.
  real cell_margin;      // A coordinate that is at least this far below the next whole number is in its cell.
  bvec3 moves;           // False on an axis whose coordinate never changes.
  bvec3 falls;           // The coordinate falls.
  bool is_moderate;      // No number as given but 0 is below 2^-40.
  bool plain;            // As given, it has no numbers but 0 and those whose significand has all its bits.
  ivec3 heading;         // -1 where the coordinate falls, else 1.
  real3 beyond;          // From a face that the ray passes to the cell behind it: -1 where the coordinate falls, else 0.
  int octant;            // A bit for each coordinate that rises, that of x lowest.
  ivec3 ahead;           // No bits where the coordinate falls, else all: picks the face of a cube that lies ahead.
};

// Empty cubes of 2^log2_side voxels a side: the one around a cell and, `count` a side, those that lie ahead of it.
struct EmptySpan {
  int log2_side;
  int count;
};

// How a ray leaves cells through the faces ahead.
struct Exit {
  real t;       // About when.
  bvec3 passed; // The axes whose faces it passes.
  bool sure;    // It is known to pass that one first.
};

// Where a ray is: the first cell not yet proved empty. Each step moves it by at least one cell, and never back.
struct Traversal {
  ivec3 cell; // In voxels; outside the volume before and after the traversal.
  int axis;   // The axis on which the ray entered the cell; -1 where it started.
  uint voxel; // Where the voxel that was hit is to be had, as the lowest level finds it.
  uint lookups;
  int steps_left; // There are no more cells on any ray; a traversal with less than 0 is an error of the kernel's.
  int pending_step; // A step over an empty span around ~cell is pending: 32 times its count, and its log2_side. Else NO_PENDING_STEP.
  ivec3 begin;      // A traversal ends where it leaves the box of `size` cells from `begin` on.
  ivec3 size;
  bool is_within; // It is known to enter its cell within the ray's bounds.
};

const int NO_PENDING_STEP = -1;
const int RETRY = -2;     // The traversal is to be gone on with, from its cell, by the exact fallback.
const int IN_BOUNDS = -3; // The exact fallback has found that it enters its cell within the ray's bounds.

const float NEVER = 1e30f; // A t that no ray of an ordinary length comes to.

// What is rounded on the way to a t, which is a difference, an inverse and a product. Where devices round to nearest, eight roundings:
// the order of two t is certain beyond 7 roundings of the earlier, and a coordinate within 7 of how far it may be from the origin. Else
// twelve roundings of 2^-23, whichever way each goes: an inverse takes 2.5 of them, the order of two t is certain beyond 11, and a
// coordinate within 9.5.
const real ROUNDINGS =
    DOUBLES ? real(8.0f / 16777216.0f) / real(536870912.0f) : real(IEEE || NEAREST ? 8.0f / 16777216.0f : 12.0f / 8388608.0f);

// A traversal that is about to begin, or to go on.
Traversal traversal_at(ivec3 cell) {
  int most_steps = VOLUME_SIZE.x + VOLUME_SIZE.y + VOLUME_SIZE.z;
  return Traversal(cell, -1, 0u, 0u, most_steps, NO_PENDING_STEP, ivec3(0), VOLUME_SIZE, false);
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

// Whether a traversal is in the box in which it may find something.
bool is_in_reach(const Traversal traversal) {
  return all(lessThan(uvec3(traversal.cell - traversal.begin), uvec3(traversal.size)));
}

// Whether a traversal has more to see here.
bool goes_on(const Traversal traversal) {
  return (BOUNDED ? is_in_reach(traversal) : is_in_volume(traversal.cell)) &&
         (!KEEPS_CELL || traversal.pending_step == NO_PENDING_STEP) &&
         (!PACKETS || lanes_at_work(traversal.steps_left) >= FEWEST_LANES);
}

// True if two cells lie in one aligned cube of 2^log2_side voxels a side.
bool is_same_cube(ivec3 a, ivec3 b, int log2_side) {
  ivec3 differ = a ^ b;
  return (differ.x | differ.y | differ.z) >> log2_side == 0;
}

// The low corner of the aligned cube of 2^log2_side voxels a side around a cell.
ivec3 corner_of(ivec3 cell, int log2_side) { return (cell >> log2_side) << log2_side; }

// The number of the ray's octant: a bit for each coordinate that rises, that of x lowest.
int octant_of(ivec3 ahead) { return (ahead.x & 1) | (ahead.y & 2) | (ahead.z & 4); }

// The low corner of the cube of an empty span around a cell.
ivec3 corner_of(const Ray ray, ivec3 cell, const EmptySpan span) {
  return corner_of(cell, span.log2_side) - (~ray.ahead & ((span.count - 1) << span.log2_side));
}

// The faces of an empty span around a cell that lie ahead.
ivec3 faces_ahead(const Ray ray, ivec3 cell, const EmptySpan span) {
  int side = 1 << span.log2_side;
  int back =
      side - (span.count << span.log2_side); // From the cube's low face to that of the empty span, where the coordinate falls.
  return (cell & -side) + back + (ray.ahead & (side - back - back));
}

// About when each coordinate passes its face.
real3 times_of(const Ray ray, real3 face) {
  real3 t = (face - ray.origin) * ray.inverse;
  return COMES_NEAR ? t - ray.late : t;
}

// The less and the greater of two numbers, none of which is NaN.
real lesser(real a, real b) { return b < a ? b : a; }
real greater(real a, real b) { return a < b ? b : a; }

// The order of float32 numbers by their bits is one instruction where others would look for NaN. Negative ones are below all others, but
// of two of them the order is the other one: no t of a face ahead is negative but by rounding.

real least_of(real3 of) {
  if (!BY_BITS)
    return lesser(lesser(of.x, of.y), of.z);
  ivec3 bits = floatBitsToInt(of);
  return intBitsToFloat(min(min(bits.x, bits.y), bits.z));
}

real second_least_of(real3 of) {
  if (!BY_BITS)
    return greater(lesser(of.x, of.y), lesser(greater(of.x, of.y), of.z));
  ivec3 bits = floatBitsToInt(of);
  return intBitsToFloat(max(min(bits.x, bits.y), min(max(bits.x, bits.y), bits.z)));
}

real greatest_of(real3 of) {
  if (!BY_BITS)
    return greater(greater(of.x, of.y), of.z);
  ivec3 bits = floatBitsToInt(of);
  return intBitsToFloat(max(max(bits.x, bits.y), bits.z));
}
