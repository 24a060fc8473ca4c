// voxc_r4_4_4_g8_*: rays through volumes of the format R(4, 4, 4) G(8), as functions for WGSL, the language of WebGPU.
//
//     fn voxc_r4_4_4_g8_closest(volume: u32, origin: vec3<f32>, direction: vec3<f32>, tmin: f32, tmax: f32,
//                         hit: ptr<function, voxc_r4_4_4_g8_Hit>) -> bool
//     fn voxc_r4_4_4_g8_next(volume: u32, origin: vec3<f32>, direction: vec3<f32>, tmax: f32, hit: ptr<function,
// voxc_r4_4_4_g8_Hit>) -> bool
//     fn voxc_r4_4_4_g8_any(volume: u32, origin: vec3<f32>, direction: vec3<f32>, tmin: f32, tmax: f32) -> bool
//     fn voxc_r4_4_4_g8_normal(hit: voxc_r4_4_4_g8_Hit) -> vec3<f32>
//     fn voxc_r4_4_4_g8_outside(origin: vec3<f32>, direction: vec3<f32>, hit: voxc_r4_4_4_g8_Hit) -> vec3<f32>
//
// A volume is a number to which you give a meaning: beside this text, say how a word of it is loaded.
//
//     @group(0) @binding(0) var<storage, read> words: array<u32>;
//     fn voxc_r4_4_4_g8_word(volume: u32, index: u32) -> u32 { return words[index]; }
//
// Rays are in voxels; a direction may have any length, and t counts in it. All that this text declares has a name that
// begins
// with voxc_r4_4_4_g8_.

// The digest 0xa67ebecd25ab0065 of the format's storage, its low half and its high one. The words of a volume are for
// these
// functions if its digest, which `voxc info` prints, equals this one, and else lead anywhere.
const voxc_r4_4_4_g8_STORAGE_DIGEST: vec2<u32> = vec2<u32>(0x25ab0065u, 0xa67ebecdu);

// Voxels along each axis.
const voxc_r4_4_4_g8_VOLUME_SIZE: vec3<i32> = vec3<i32>(4096, 4096, 4096);

// Functions of GLSL on words with carries that other languages lack.

fn voxc_r4_4_4_g8_uaddCarry(a: u32, b: u32, carry: ptr<function, u32>) -> u32 {
  let sum = a + b;
  *carry = select(0u, 1u, sum < a);
  return sum;
}

fn voxc_r4_4_4_g8_usubBorrow(a: u32, b: u32, borrow: ptr<function, u32>) -> u32 {
  *borrow = select(0u, 1u, a < b);
  return a - b;
}

// By halves of 16 bits.
fn voxc_r4_4_4_g8_umulExtended(a: u32, b: u32, high: ptr<function, u32>, low: ptr<function, u32>) {
  let a_low = a & 0xffffu;
  let a_high = a >> 16u;
  let b_low = b & 0xffffu;
  let b_high = b >> 16u;
  let lowest = a_low * b_low;
  let middle = a_high * b_low + (lowest >> 16u);
  let other = a_low * b_high + (middle & 0xffffu);
  *high = a_high * b_high + (middle >> 16u) + (other >> 16u);
  *low = (other << 16u) | (lowest & 0xffffu);
}

fn voxc_r4_4_4_g8_load_word(volume: u32, place: u32) -> u32 { return voxc_r4_4_4_g8_word(volume, place); }

// A ray, prepared for the traversal. Its members that are no integers are approximate; what must be exact is asked of
// the ray as given.
struct voxc_r4_4_4_g8_Ray {
  given_origin: vec3<u32>, // The bits of six float32 taken as exact numbers.
  given_direction: vec3<u32>,
  origin: vec3<f32>,       // Where the traversal counts from: the given origin, or where a ray from far away enters.
  // Scaled so that the longest component is in [1, 2). Where a coordinate never changes it is LEAST_COMPONENT: that
  // passes no face before another does. All t are those of this direction, from this origin.
  direction: vec3<f32>,
  inverse: vec3<f32>,
  late: vec3<f32>,         // By how much each t comes late that is counted from there.
  t_error: f32,            // Absolute error bound of t, apart from a few rounding errors.
  origin_low: vec3<f32>,   // The least that is certain of the coordinates at the origin,
  coordinate_error: f32,   // and how much more any coordinate on the way may be, in voxels.
  cell_margin: f32,        // A coordinate that is at least this far below the next whole number is in its cell.
  moves: vec3<bool>,       // False on an axis whose coordinate never changes.
  falls: vec3<bool>,       // The coordinate falls.
  plain: bool,             // As given, it has no numbers but 0 and those whose significand has all its bits.
  heading: vec3<i32>,      // -1 where the coordinate falls, else 1.
  // From a face that the ray passes to the cell behind it: -1 where the coordinate falls, else 0.
  beyond: vec3<f32>,
  ahead: vec3<i32>,        // No bits where the coordinate falls, else all: picks the face of a cube that lies ahead.
}

// Empty cubes of 2^log2_side voxels a side: the one around a cell and, `count` a side, those that lie ahead of it.
struct voxc_r4_4_4_g8_EmptySpan {
  log2_side: i32,
  count: i32,
}

// How a ray leaves cells through the faces ahead.
struct voxc_r4_4_4_g8_Exit {
  t: f32,             // About when.
  passed: vec3<bool>, // The axes whose faces it passes.
  sure: bool,         // It is known to pass that one first.
}

// Where a ray is: the first cell not yet proved empty. Each step moves it by at least one cell, and never back.
struct voxc_r4_4_4_g8_Traversal {
  cell: vec3<i32>,   // In voxels; outside the volume before and after the traversal.
  axis: i32,         // The axis on which the ray entered the cell; -1 where it started.
  voxel: u32,        // Where the voxel that was hit is to be had, as the lowest level finds it.
  steps_left: i32,   // There are no more cells on any ray; a traversal with less than 0 is an error of the kernel's.
  // A step over an empty span around ~cell is pending: 32 times its count, and its log2_side. Else NO_PENDING_STEP.
  pending_step: i32,
  begin: vec3<i32>,  // A traversal ends where it leaves the box of `size` cells from `begin` on.
  size: vec3<i32>,
}

const voxc_r4_4_4_g8_NO_PENDING_STEP: i32 = -1;
const voxc_r4_4_4_g8_RETRY: i32 = -2; // The traversal is to be gone on with, from its cell, by the exact fallback.

const voxc_r4_4_4_g8_NEVER: f32 = 1e30f; // A t that no ray of an ordinary length comes to.

// What is rounded on the way to a t, which is a difference, an inverse and a product. Where devices round to nearest,
// eight roundings: the order of two t is certain beyond 7 roundings of the earlier, and a coordinate within 7 of how
// far it may be from the origin. Else twelve roundings of 2^-23, whichever way each goes: an inverse takes 2.5 of them,
// the order of two t is certain beyond 11, and a coordinate within 9.5.
const voxc_r4_4_4_g8_ROUNDINGS: f32 = 12.0f / 8388608.0f;

// A traversal that is about to begin, or to go on.
fn voxc_r4_4_4_g8_traversal_at(cell: vec3<i32>) -> voxc_r4_4_4_g8_Traversal {
  let most_steps = voxc_r4_4_4_g8_VOLUME_SIZE.x + voxc_r4_4_4_g8_VOLUME_SIZE.y + voxc_r4_4_4_g8_VOLUME_SIZE.z;
  return voxc_r4_4_4_g8_Traversal(cell, -1, 0u, most_steps, voxc_r4_4_4_g8_NO_PENDING_STEP, vec3<i32>(0),
      voxc_r4_4_4_g8_VOLUME_SIZE);
}

// Ends a traversal that takes more steps than any can.
fn voxc_r4_4_4_g8_count_step(traversal: ptr<function, voxc_r4_4_4_g8_Traversal>) {
  (*traversal).steps_left--;
  (*traversal).cell.x |= (*traversal).steps_left >> 31u; // All bits: outside, whatever follows.
}

fn voxc_r4_4_4_g8_is_in_volume(cell: vec3<i32>) -> bool {
  return all(vec3<u32>(cell) < vec3<u32>(voxc_r4_4_4_g8_VOLUME_SIZE));
}

// Whether a traversal is in the box in which it may find something.
fn voxc_r4_4_4_g8_is_in_reach(traversal: voxc_r4_4_4_g8_Traversal) -> bool {
  return all(vec3<u32>(traversal.cell - traversal.begin) < vec3<u32>(traversal.size));
}

// Whether a traversal has more to see here.
fn voxc_r4_4_4_g8_goes_on(traversal: voxc_r4_4_4_g8_Traversal) -> bool { return voxc_r4_4_4_g8_is_in_reach(traversal); }

// The low corner of the aligned cube of 2^log2_side voxels a side around a cell.
fn voxc_r4_4_4_g8_corner_of(cell: vec3<i32>, log2_side: i32) -> vec3<i32> {
  return (cell >> vec3<u32>(u32(log2_side))) << vec3<u32>(u32(log2_side));
}

// The low corner of the cube of an empty span around a cell.
fn voxc_r4_4_4_g8_corner_of_emptyspan(ray: voxc_r4_4_4_g8_Ray, cell: vec3<i32>,
    span: voxc_r4_4_4_g8_EmptySpan) -> vec3<i32> {
  return voxc_r4_4_4_g8_corner_of(cell, span.log2_side) - (~ray.ahead & vec3<i32>((span.count
      - 1) << u32(span.log2_side)));
}

// The faces of an empty span around a cell that lie ahead.
fn voxc_r4_4_4_g8_faces_ahead(ray: voxc_r4_4_4_g8_Ray, cell: vec3<i32>, span: voxc_r4_4_4_g8_EmptySpan) -> vec3<i32> {
  let side = 1 << u32(span.log2_side);
  // From the cube's low face to that of the empty span, where the coordinate falls.
  let back = side - (span.count << u32(span.log2_side));
  return (cell & vec3<i32>(-side)) + back + (ray.ahead & vec3<i32>(side - back - back));
}

// About when each coordinate passes its face.
fn voxc_r4_4_4_g8_times_of(ray: voxc_r4_4_4_g8_Ray, face: vec3<f32>) -> vec3<f32> {
  return (face - ray.origin) * ray.inverse;
}

// The order of float32 numbers by their bits is one instruction where others would look for NaN. Negative ones are
// below all others, but of two of them the order is the other one: no t of a face ahead is negative but by rounding.

fn voxc_r4_4_4_g8_least_of(of_: vec3<f32>) -> f32 {
  let bits = bitcast<vec3<i32>>(of_);
  return bitcast<f32>(min(min(bits.x, bits.y), bits.z));
}

fn voxc_r4_4_4_g8_second_least_of(of_: vec3<f32>) -> f32 {
  let bits = bitcast<vec3<i32>>(of_);
  return bitcast<f32>(max(min(bits.x, bits.y), min(max(bits.x, bits.y), bits.z)));
}

fn voxc_r4_4_4_g8_greatest_of(of_: vec3<f32>) -> f32 {
  let bits = bitcast<vec3<i32>>(of_);
  return bitcast<f32>(max(max(bits.x, bits.y), bits.z));
}

// Float32 numbers as integers: significand * 2^(exponent - 150). No device flushes or rounds these.

const voxc_r4_4_4_g8_SIGN_BIT: u32 = 0x80000000u;
const voxc_r4_4_4_g8_INFINITY_BITS: u32 = 0x7f800000u;

// Below 2^24.
fn voxc_r4_4_4_g8_significand_of(bits: u32) -> u32 {
  let fraction = bits & 0x7fffffu;
  return select(fraction | 0x800000u, fraction, (bits & voxc_r4_4_4_g8_INFINITY_BITS) == 0u);
}

fn voxc_r4_4_4_g8_exponent_of(bits: u32) -> i32 { return max(i32((bits >> 23u) & 0xffu), 1); }

fn voxc_r4_4_4_g8_are_finite(bits: vec3<u32>) -> bool {
  return all((bits & vec3<u32>(voxc_r4_4_4_g8_INFINITY_BITS)) < vec3<u32>(voxc_r4_4_4_g8_INFINITY_BITS));
}

// True if each is 0 or has a significand of 24 bits, as devices do not always keep smaller ones.
fn voxc_r4_4_4_g8_are_plain(bits: vec3<u32>) -> bool {
  return all(((bits & vec3<u32>(~voxc_r4_4_4_g8_SIGN_BIT)) - 1u) >= vec3<u32>(0x7fffffu));
}

// 2^exponent, for exponents of normal numbers; the nearest such for others.
fn voxc_r4_4_4_g8_power_of_two(exponent: i32) -> f32 {
  return bitcast<f32>(u32(clamp(exponent, -126, 127) + 127) << 23u);
}

// The bits of the longest component's magnitude.
fn voxc_r4_4_4_g8_longest_of(direction: vec3<u32>) -> u32 {
  let size = direction & vec3<u32>(~voxc_r4_4_4_g8_SIGN_BIT);
  return max(max(size.x, size.y), size.z);
}

// The largest whole numbers that are not above float32 numbers, within 2^22 of zero.
fn voxc_r4_4_4_g8_floor_of(bits: vec3<u32>) -> vec3<i32> {
  let whole = vec3<i32>(clamp(floor(bitcast<vec3<f32>>(bits)), vec3<f32>(-4194304.0f), vec3<f32>(4194304.0f)));
  // Below 1, a denormal number may not survive arithmetic.
  let small = -vec3<i32>(bits > vec3<u32>(voxc_r4_4_4_g8_SIGN_BIT));
  return select(whole, small, (bits & vec3<u32>(~voxc_r4_4_4_g8_SIGN_BIT)) < vec3<u32>(0x3f800000u));
}

// The exact sign of a sum of four products of float32 numbers.

// A sum in two's complement, times 2^(exponent - 300). Its sign is exact, its value within 2^-11 of itself.
struct voxc_r4_4_4_g8_Sum {
  high: i32,
  low: u32,
  exponent: i32,
}

fn voxc_r4_4_4_g8_sign_of(sum: voxc_r4_4_4_g8_Sum) -> i32 {
  return select(select(0, 1, (u32(sum.high) | sum.low) != 0u), -1, sum.high < 0);
}

// The largest p for which 2^p is not above the magnitude; -1 for 0, and for -1 too.
fn voxc_r4_4_4_g8_log2_of(sum: voxc_r4_4_4_g8_Sum) -> i32 {
  let flip = u32(sum.high >> 31u);
  let high = u32(sum.high) ^ flip;
  return i32(firstLeadingBit(select(sum.low ^ flip, high, high != 0u))) + select(0, 32, high != 0u);
}

// Makes `shift` bits, at most 61, of room at the low end.
fn voxc_r4_4_4_g8_shift_left(sum: ptr<function, voxc_r4_4_4_g8_Sum>, shift: i32) {
  var high: u32 = u32((*sum).high);
  if (shift >= 32) {
    high = (*sum).low << u32(shift - 32);
    (*sum).low = 0u;
  } else if (shift > 0) {
    high = (high << u32(shift)) | ((*sum).low >> u32(32 - shift));
    (*sum).low <<= u32(shift);
  }
  (*sum).high = i32(high);
  (*sum).exponent -= shift;
}

fn voxc_r4_4_4_g8_add(sum: ptr<function, voxc_r4_4_4_g8_Sum>, high: u32, low: u32, negative: bool) {
  let flip = select(0u, ~0u, negative);
  var carry_of_low: u32; var carry_of_sign: u32;
  let partial = voxc_r4_4_4_g8_uaddCarry((*sum).low, low ^ flip, &carry_of_low);
  (*sum).low = voxc_r4_4_4_g8_uaddCarry(partial, flip & 1u, &carry_of_sign);
  (*sum).high = i32(u32((*sum).high) + (high ^ flip) + carry_of_low + carry_of_sign);
}

// a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w, of bits of float32. A product is below 2^48 times its power of two.
// They are added from the largest power down; once the sum has 61 bits at the next power, all that is left is too small
// to change its sign.
fn voxc_r4_4_4_g8_sum_of_products(a: vec4<u32>, b: vec4<u32>) -> voxc_r4_4_4_g8_Sum {
  var exponent: vec4<i32> = vec4<i32>(voxc_r4_4_4_g8_exponent_of(a.x) + voxc_r4_4_4_g8_exponent_of(b.x),
      voxc_r4_4_4_g8_exponent_of(a.y) + voxc_r4_4_4_g8_exponent_of(b.y),
      voxc_r4_4_4_g8_exponent_of(a.z) + voxc_r4_4_4_g8_exponent_of(b.z),
      voxc_r4_4_4_g8_exponent_of(a.w) + voxc_r4_4_4_g8_exponent_of(b.w));
  var sum: voxc_r4_4_4_g8_Sum = voxc_r4_4_4_g8_Sum(0, 0u, 0);
  var left: i32 = 4;
  while (left > 0) {
    let largest = max(max(exponent.x, exponent.y), max(exponent.z, exponent.w));
    let next = select(select(select(3, 2, exponent.z == largest), 1, exponent.y == largest), 0, exponent.x == largest);
    var high: u32; var low: u32;
    voxc_r4_4_4_g8_umulExtended(voxc_r4_4_4_g8_significand_of(a[next]), voxc_r4_4_4_g8_significand_of(b[next]), &high,
        &low);
    if (voxc_r4_4_4_g8_sign_of(sum) == 0) {
      sum.exponent = largest;
    }
    let shift = sum.exponent - largest;
    exponent[next] = -1;
    left--;
    if (voxc_r4_4_4_g8_log2_of(sum) + shift >= 61) {
      left = 0;
    } else {
      voxc_r4_4_4_g8_shift_left(&sum, shift);
      voxc_r4_4_4_g8_add(&sum, high, low, (a[next] ^ b[next]) >= voxc_r4_4_4_g8_SIGN_BIT);
    }
  }
  return sum;
}

// sum / divisor in plain float32.
fn voxc_r4_4_4_g8_quotient(sum: voxc_r4_4_4_g8_Sum, divisor: u32) -> f32 {
  let negative = sum.high < 0;
  var magnitude: voxc_r4_4_4_g8_Sum = voxc_r4_4_4_g8_Sum(0, 0u, sum.exponent);
  voxc_r4_4_4_g8_add(&magnitude, u32(sum.high), sum.low, negative);
  let value = f32(magnitude.high) * 4294967296.0f + f32(magnitude.low);
  let size = value / f32(voxc_r4_4_4_g8_significand_of(divisor)) * voxc_r4_4_4_g8_power_of_two(sum.exponent
      - voxc_r4_4_4_g8_exponent_of(divisor) - 150);
  return select(size, -size, negative != (divisor >= voxc_r4_4_4_g8_SIGN_BIT));
}

// The moments at which a ray changes cell, in exact order. Cells are half-open, so where several coordinates pass a
// face at one t, rising ones change cell first, falling ones just after.

// A change of cell.
struct voxc_r4_4_4_g8_Crossing {
  t: f32,          // Approximate.
  axis: i32,       // One that changes,
  face: i32,       // and the face that it passes.
  step: vec3<i32>, // The change, a cell at most on each axis.
  rising: bool,    // Only rising coordinates change: those that fall may still stand on a boundary.
}

// The change of cell where a ray leaves a cube through the faces ahead: `crossed` tells the axes whose coordinates pass
// them first, about at t.
fn voxc_r4_4_4_g8_crossing_of(ray: voxc_r4_4_4_g8_Ray, face: vec3<i32>, t: f32,
    crossed: vec3<bool>) -> voxc_r4_4_4_g8_Crossing {
  let changes = select(vec3<i32>(0), ray.heading, crossed);
  let risen = max(changes, vec3<i32>(0));
  var crossing: voxc_r4_4_4_g8_Crossing;
  crossing.rising = any(risen != vec3<i32>(0));
  crossing.step = select(changes, risen, crossing.rising);
  crossing.axis = select(select(2, 1, crossing.step.y != 0), 0, crossing.step.x != 0);
  crossing.t = t;
  crossing.face = face[crossing.axis];
  return crossing;
}

// Cells from `least` to `most`.
struct voxc_r4_4_4_g8_Range {
  least: vec3<i32>,
  most: vec3<i32>,
}

// How far coordinate a is behind at_a when coordinate b passes at_b, with the sign of both speeds:
// (at_a - origin_a) * direction_b - (at_b - origin_b) * direction_a.
fn voxc_r4_4_4_g8_crossing_difference(ray: voxc_r4_4_4_g8_Ray, a: i32, at_a: f32, b: i32,
    at_b: f32) -> voxc_r4_4_4_g8_Sum {
  let speed_a = ray.given_direction[a];
  let speed_b = ray.given_direction[b];
  return voxc_r4_4_4_g8_sum_of_products(vec4<u32>(bitcast<u32>(at_a), ray.given_origin[a] ^ voxc_r4_4_4_g8_SIGN_BIT,
      bitcast<u32>(at_b) ^ voxc_r4_4_4_g8_SIGN_BIT, ray.given_origin[b]), vec4<u32>(speed_b, speed_b, speed_a,
      speed_a));
}

// -1 if coordinate a passes its face first, 0 if both pass theirs at the same t, else 1. Both move.
fn voxc_r4_4_4_g8_compare_exactly(ray: voxc_r4_4_4_g8_Ray, a: i32, face_a: i32, b: i32, face_b: i32) -> i32 {
  let difference = voxc_r4_4_4_g8_crossing_difference(ray, a, f32(face_a), b, f32(face_b));
  let order = voxc_r4_4_4_g8_sign_of(difference);
  return select(-order, order, ray.falls[a] == ray.falls[b]);
}

// The same, by doubles where they can decide.
fn voxc_r4_4_4_g8_compare_crossings(ray: voxc_r4_4_4_g8_Ray, a: i32, face_a: i32, b: i32, face_b: i32) -> i32 {
  return voxc_r4_4_4_g8_compare_exactly(ray, a, face_a, b, face_b);
}

fn voxc_r4_4_4_g8_undecided_axis(range: voxc_r4_4_4_g8_Range) -> i32 {
  return select(select(2, 1, range.least.y != range.most.y), 0, range.least.x != range.most.x);
}

fn voxc_r4_4_4_g8_middle_of(range: voxc_r4_4_4_g8_Range, axis: i32) -> i32 {
  return range.least[axis] + (range.most[axis] - range.least[axis] + 1) / 2;
}

// Takes away from a range what lies to one side of a face, where `order` compares it with the crossing.
fn voxc_r4_4_4_g8_narrow(ray: voxc_r4_4_4_g8_Ray, crossing: voxc_r4_4_4_g8_Crossing, axis: i32, face: i32, order: i32,
    range: ptr<function, voxc_r4_4_4_g8_Range>) {
  let falls = ray.falls[axis];
  let passed = (order < 0) || (order == 0 && !(falls && crossing.rising));
  if (passed != falls) {
    (*range).least[axis] = face;
  } else {
    (*range).most[axis] = face - 1;
  }
}

// Narrows a range down, on each axis, to the cell that the ray is in once a crossing has happened.
fn voxc_r4_4_4_g8_resolve_cell(ray: voxc_r4_4_4_g8_Ray, crossing: voxc_r4_4_4_g8_Crossing,
    candidates: voxc_r4_4_4_g8_Range) -> vec3<i32> {
  var range: voxc_r4_4_4_g8_Range = candidates;
  while (any(range.least != range.most)) {
    let axis = voxc_r4_4_4_g8_undecided_axis(range);
    let face = voxc_r4_4_4_g8_middle_of(range, axis);
    voxc_r4_4_4_g8_narrow(ray, crossing, axis, face, voxc_r4_4_4_g8_compare_crossings(ray, axis, face, crossing.axis,
        crossing.face), &range);
  }
  return range.least;
}

// What can be told, without integers, of the cell, within a range, that the ray is in once a crossing has happened.
fn voxc_r4_4_4_g8_approximate_cell(ray: voxc_r4_4_4_g8_Ray, crossing: voxc_r4_4_4_g8_Crossing,
    range: voxc_r4_4_4_g8_Range) -> voxc_r4_4_4_g8_Range {
  let point = ray.origin_low + crossing.t * ray.direction;
  let bound = select(vec3<f32>(0.0f), vec3<f32>(ray.coordinate_error), ray.moves);
  let least = vec3<f32>(range.least);
  let most = vec3<f32>(range.most);
  return voxc_r4_4_4_g8_Range(vec3<i32>(clamp(floor(point), least, most)), vec3<i32>(clamp(floor(point + bound), least,
      most)));
}

// Steps that are exact for every ray: by float32 or doubles where these can decide, by integers elsewhere.

// How the ray leaves cells through the first of the faces ahead. Not sure if its t cannot decide which that is.
fn voxc_r4_4_4_g8_leave(ray: voxc_r4_4_4_g8_Ray, face: vec3<f32>) -> voxc_r4_4_4_g8_Exit {
  let t = voxc_r4_4_4_g8_times_of(ray, face);
  let first = voxc_r4_4_4_g8_least_of(t);
  let second = voxc_r4_4_4_g8_second_least_of(t); // Of negative ones, none that is sure.
  return voxc_r4_4_4_g8_Exit(first, t == vec3<f32>(first),
      second > first + (first * voxc_r4_4_4_g8_ROUNDINGS + ray.t_error));
}

// The cell that a ray comes to where it leaves others, of which `cell` is one, by one of the faces ahead. Not sure if
// its point cannot decide on which side of another face that is.
fn voxc_r4_4_4_g8_cell_beyond(ray: voxc_r4_4_4_g8_Ray, face: vec3<f32>, leaving: ptr<function,
    voxc_r4_4_4_g8_Exit>) -> vec3<i32> {
  let point = select(ray.origin_low + (*leaving).t * ray.direction, face + ray.beyond, (*leaving).passed);
  let whole = floor(point);
  let is_certain = voxc_r4_4_4_g8_greatest_of(point - whole) < ray.cell_margin;
  (*leaving).sure = (*leaving).sure && is_certain;
  return vec3<i32>(whole);
}

// Resolves the step over the empty span around the traversal's cell: which faces the ray passes first, of those that
// float32 cannot decide apart, and then by bisection to which cell it comes. All questions are asked at one place,
// since devices of wide vectors run through it as often as any ray needs it. Where the device cuts it short, the
// traversal stays where it is.
fn voxc_r4_4_4_g8_exact_step(ray: voxc_r4_4_4_g8_Ray, given_traversal: voxc_r4_4_4_g8_Traversal,
    span: voxc_r4_4_4_g8_EmptySpan) -> voxc_r4_4_4_g8_Traversal {
  var traversal: voxc_r4_4_4_g8_Traversal = given_traversal;
  let side = span.count << u32(span.log2_side);
  let corner = voxc_r4_4_4_g8_corner_of_emptyspan(ray, traversal.cell, span);
  let face = corner + (ray.ahead & vec3<i32>(side));
  let t = voxc_r4_4_4_g8_times_of(ray, vec3<f32>(face));
  let earliest = min(min(t.x, t.y), t.z);
  let may_be_first = t <= vec3<f32>(earliest + (earliest * voxc_r4_4_4_g8_ROUNDINGS + ray.t_error));
  let bits = vec3<i32>(may_be_first) * vec3<i32>(ray.moves);
  var axes: i32 = bits.x | (bits.y << 1u) | (bits.z << 2u);
  var first: i32 = i32(firstTrailingBit(u32(axes)));
  axes &= axes - 1;
  var crossed: vec3<bool> = vec3<bool>(first == 0, first == 1, first == 2);
  var crossing: voxc_r4_4_4_g8_Crossing;
  var range: voxc_r4_4_4_g8_Range = voxc_r4_4_4_g8_Range(vec3<i32>(0), vec3<i32>(1));
  var orders: bool = true;
  var order: i32 = 0;
  while (any(range.least != range.most)) {
    if (orders && axes == 0) {
      orders = false;
      crossing = voxc_r4_4_4_g8_crossing_of(ray, face, earliest, crossed);
      let target_ = corner + crossing.step * side;
      range = voxc_r4_4_4_g8_approximate_cell(ray, crossing, voxc_r4_4_4_g8_Range(target_, target_ + (side - 1)));
    }
    if (orders || any(range.least != range.most)) {
      var axis: i32;
      if (orders) {
        axis = i32(firstTrailingBit(u32(axes)));
      } else {
        axis = voxc_r4_4_4_g8_undecided_axis(range);
      }
      var at: i32;
      if (orders) {
        at = face[axis];
      } else {
        at = voxc_r4_4_4_g8_middle_of(range, axis);
      }
      order = voxc_r4_4_4_g8_compare_crossings(ray, axis, at, first, face[first]);
      if (!orders) {
        voxc_r4_4_4_g8_narrow(ray, crossing, axis, at, order, &range);
      } else {
        if (order <= 0) {
          let others = select(crossed, vec3<bool>(false), order < 0);
          crossed = vec3<bool>(others.x || (axis == 0), others.y || (axis == 1), others.z || (axis == 2));
          first = axis;
        }
        axes &= axes - 1;
      }
    }
  }
  if (all(range.least == range.most)) {
    traversal.cell = range.least;
    traversal.axis = crossing.axis;
  }
  return traversal;
}

// Resolves the step of a traversal that is pending.
fn voxc_r4_4_4_g8_resolve_step(ray: voxc_r4_4_4_g8_Ray, traversal: ptr<function, voxc_r4_4_4_g8_Traversal>) {
  let span = voxc_r4_4_4_g8_EmptySpan((*traversal).pending_step & 31, (*traversal).pending_step >> 5u);
  (*traversal).pending_step = voxc_r4_4_4_g8_NO_PENDING_STEP;
  (*traversal).cell = ~(*traversal).cell;
  *traversal = voxc_r4_4_4_g8_exact_step(ray, *traversal, span);
}

// Steps from one cell of the ray to the next.

// Ends a step over the empty span around the traversal's cell, or over that and more, which leads to another cell if
// that is sure.
fn voxc_r4_4_4_g8_end_step(traversal: ptr<function, voxc_r4_4_4_g8_Traversal>, leaving: voxc_r4_4_4_g8_Exit,
    cell: vec3<i32>, span: voxc_r4_4_4_g8_EmptySpan) {
  (*traversal).axis = select(select(0, 1, leaving.passed.y), 2, leaving.passed.z);
  let sure = leaving.sure;
  // A step that is not sure is left pending, and all loops end: what resolves it stands outside of them, where lanes
  // that are sure need not wait for it.
  // The next turn may read what is there before it is known if the step is sure.
  (*traversal).cell = select(~(*traversal).cell, cell, sure);
  (*traversal).pending_step = select((span.count << 5u) | span.log2_side, voxc_r4_4_4_g8_NO_PENDING_STEP, sure);
  voxc_r4_4_4_g8_count_step(traversal);
}

// Steps over the empty span around the traversal's cell, of which these faces lie ahead.
fn voxc_r4_4_4_g8_step_over(ray: voxc_r4_4_4_g8_Ray, traversal: ptr<function, voxc_r4_4_4_g8_Traversal>,
    span: voxc_r4_4_4_g8_EmptySpan, face: vec3<f32>) {
  var leaving: voxc_r4_4_4_g8_Exit = voxc_r4_4_4_g8_leave(ray, face);
  let cell = voxc_r4_4_4_g8_cell_beyond(ray, face, &leaving);
  voxc_r4_4_4_g8_end_step(traversal, leaving, cell, span);
}

// Steps over the empty span around the traversal's cell.
fn voxc_r4_4_4_g8_step_over_emptyspan(ray: voxc_r4_4_4_g8_Ray, traversal: ptr<function, voxc_r4_4_4_g8_Traversal>,
    span: voxc_r4_4_4_g8_EmptySpan) {
  voxc_r4_4_4_g8_step_over(ray, traversal, span, vec3<f32>(voxc_r4_4_4_g8_faces_ahead(ray, (*traversal).cell, span)));
}

// Steps over the empty cube of 2^log2_side voxels a side around the traversal's cell.
fn voxc_r4_4_4_g8_step_over_int(ray: voxc_r4_4_4_g8_Ray, traversal: ptr<function, voxc_r4_4_4_g8_Traversal>,
    log2_side: i32) {
  voxc_r4_4_4_g8_step_over_emptyspan(ray, traversal, voxc_r4_4_4_g8_EmptySpan(log2_side, 1));
}

// Steps from the traversal's voxel, which is empty, to the next.
fn voxc_r4_4_4_g8_step_over_voxel(ray: voxc_r4_4_4_g8_Ray, traversal: ptr<function, voxc_r4_4_4_g8_Traversal>) {
  let leaving = voxc_r4_4_4_g8_leave(ray, vec3<f32>((*traversal).cell - ray.ahead));
  voxc_r4_4_4_g8_end_step(traversal, leaving, (*traversal).cell + select(vec3<i32>(0), ray.heading, leaving.passed),
      voxc_r4_4_4_g8_EmptySpan(0, 1));
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
fn voxc_r4_4_4_g8_far_away() -> f32 {
  let side = max(max(voxc_r4_4_4_g8_VOLUME_SIZE.x, voxc_r4_4_4_g8_VOLUME_SIZE.y), voxc_r4_4_4_g8_VOLUME_SIZE.z);
  // In doubles, of a component that was raised to LEAST_COMPONENT, a t that is not larger makes less than one rounding.
  return f32(2 * side);
}

// What is known of a ray that may have been moved.
struct voxc_r4_4_4_g8_Start {
  is_far: bool, // It still begins far away, and float32 tells nothing of it.
  wrong: f32,   // What may be wrong of its coordinates, beside a few roundings,
  t_error: f32, // and of a t.
}

fn voxc_r4_4_4_g8_is_far(coordinate: vec3<f32>, moves: vec3<bool>) -> bool {
  return any(abs(coordinate) > select(vec3<f32>(voxc_r4_4_4_g8_NEVER), vec3<f32>(voxc_r4_4_4_g8_far_away()), moves));
}

// Moves a ray that begins far away, to before the last of the faces by which it enters the volume. Once is enough up to
// a thousand times that distance.
fn voxc_r4_4_4_g8_come_near(ray: ptr<function, voxc_r4_4_4_g8_Ray>) -> voxc_r4_4_4_g8_Start {
  // No ordinary ray is, if none comes near.
  return voxc_r4_4_4_g8_Start(voxc_r4_4_4_g8_is_far((*ray).origin, (*ray).moves), 0.0f, 0.0f);
}

// Where a traversal begins: in the cell of the ray's origin, or in the first cell of the volume that the ray comes to.

const voxc_r4_4_4_g8_CLOSE: f32 = 1.0f / 2048.0f; // In voxels.

// Bounds what float32 gets wrong in a traversal through the volume, where the origin itself is wrong by `of_origin`,
// and a t by `t_error`. A coordinate that never changes stays in its cell.
fn voxc_r4_4_4_g8_bound_errors(ray: ptr<function, voxc_r4_4_4_g8_Ray>, cell: vec3<f32>, of_origin: f32, t_error: f32) {
  let half_size = 0.5f * vec3<f32>(voxc_r4_4_4_g8_VOLUME_SIZE);
  let reach = abs((*ray).origin - half_size) + half_size; // To the farther of the volume's two faces.
  var error: f32 = voxc_r4_4_4_g8_greatest_of(reach) * voxc_r4_4_4_g8_ROUNDINGS + of_origin;
  error = min(error + 2.0f * t_error, voxc_r4_4_4_g8_NEVER);
  (*ray).t_error = t_error;
  (*ray).origin_low = select(cell + 0.25f, (*ray).origin - error, (*ray).moves);
  (*ray).coordinate_error = 2.0f * error;
  (*ray).cell_margin = 1.0f - (*ray).coordinate_error;
}

// True where the ray moves from a coordinate so close to 0 that it may pass that face before float32 says so, as scaled
// directions have no component below 2^-60.
fn voxc_r4_4_4_g8_starts_tiny(ray: voxc_r4_4_4_g8_Ray) -> vec3<bool> {
  let TINY_BITS = 0x30800000u; // Of 2^-30.
  let size = ray.given_origin & vec3<u32>(~voxc_r4_4_4_g8_SIGN_BIT);
  let tiny = (size - 1u) < vec3<u32>(TINY_BITS - 1u);
  return (vec3<i32>(tiny) * vec3<i32>(ray.moves)) > vec3<i32>(0);
}

// Of the axes that let the ray into their slab at a face, the last, where a falling one comes after a rising one.
fn voxc_r4_4_4_g8_last_entered(ray: voxc_r4_4_4_g8_Ray, enters: vec3<bool>, face: vec3<i32>) -> i32 {
  var last: i32 = -1;
  for (var axis: i32 = 0; axis < 3; axis++) {
    if (enters[axis]) {
      var order: i32;
      if (last < 0) {
        order = 1;
      } else {
        order = voxc_r4_4_4_g8_compare_crossings(ray, axis, face[axis], last, face[last]);
      }
      if ((order > 0) || (order == 0 && ray.falls[axis])) {
        last = axis;
      }
    }
  }
  return last;
}

// The coordinate, kept within a voxel of the volume, that a ray has where it passes a face. Each turn leaves less than
// 2^-10 of the error of the guess before, and what float32 rounds.
fn voxc_r4_4_4_g8_coordinate_at(ray: voxc_r4_4_4_g8_Ray, axis: i32, face: i32, other: i32) -> f32 {
  let size = f32(voxc_r4_4_4_g8_VOLUME_SIZE[other]);
  var at: f32 = 0.5f * size;
  for (var error: f32 = size; error > voxc_r4_4_4_g8_CLOSE; error *= 1.0f / 1024.0f) {
    let move_ = voxc_r4_4_4_g8_quotient(voxc_r4_4_4_g8_crossing_difference(ray, axis, f32(face), other, at),
        ray.given_direction[axis]);
    at = clamp(at + move_, -1.0f, size + 1.0f);
  }
  return at;
}

// Lets a ray from far away start where it passes a face, so that its errors do not grow with its distance.
fn voxc_r4_4_4_g8_start_at(ray: ptr<function, voxc_r4_4_4_g8_Ray>, cell: vec3<i32>, axis: i32, face: i32) {
  var error: f32 = 0.0f;
  for (var other: i32 = 0; other < 3; other++) {
    if (other == axis) {
      (*ray).origin[other] = f32(face);
    } else if ((*ray).moves[other]) {
      (*ray).origin[other] = voxc_r4_4_4_g8_coordinate_at(*ray, axis, face, other);
      // More than a few roundings.
      error = max(error, voxc_r4_4_4_g8_CLOSE + voxc_r4_4_4_g8_CLOSE * abs((*ray).origin[other]) / 256.0f);
    }
  }
  let steep = select(vec3<f32>(0.0f), abs((*ray).inverse), (*ray).moves);
  (*ray).late = vec3<f32>(0.0f);
  voxc_r4_4_4_g8_bound_errors(ray, vec3<f32>(cell), error, 2.0f * error * max(max(steep.x, steep.y), steep.z));
}

// Puts a traversal into the cell that the ray comes to where it passes a face, in exact arithmetic. `cell` tells the
// coordinates that never change.
fn voxc_r4_4_4_g8_behind_face(ray: voxc_r4_4_4_g8_Ray, given_traversal: voxc_r4_4_4_g8_Traversal, cell: vec3<i32>,
    axis: i32, face: i32) -> voxc_r4_4_4_g8_Traversal {
  var traversal: voxc_r4_4_4_g8_Traversal = given_traversal;
  var crossing: voxc_r4_4_4_g8_Crossing;
  crossing.t = (f32(face) - ray.origin[axis]) * ray.inverse[axis] - ray.late[axis];
  crossing.axis = axis;
  crossing.face = face;
  crossing.rising = !ray.falls[axis];
  var range: voxc_r4_4_4_g8_Range = voxc_r4_4_4_g8_Range(select(cell, vec3<i32>(-1), ray.moves), select(cell,
      voxc_r4_4_4_g8_VOLUME_SIZE, ray.moves));
  range.most[axis] = face - select(0, 1, ray.falls[axis]);
  range.least[axis] = range.most[axis];
  range = voxc_r4_4_4_g8_approximate_cell(ray, crossing, range);
  var behind: vec3<i32> = range.least;
  behind = voxc_r4_4_4_g8_resolve_cell(ray, crossing, range);
  traversal.cell = behind;
  traversal.axis = axis;
  return traversal;
}

// Finds the cell in which the ray enters the volume, in exact arithmetic: that of its origin, or through the last of
// the faces that it must pass. A cell outside if there is none.
fn voxc_r4_4_4_g8_entered_exactly(ray: ptr<function, voxc_r4_4_4_g8_Ray>, given_traversal: voxc_r4_4_4_g8_Traversal,
    starts_far: bool) -> voxc_r4_4_4_g8_Traversal {
  var traversal: voxc_r4_4_4_g8_Traversal = given_traversal;
  let cell = voxc_r4_4_4_g8_floor_of((*ray).given_origin);
  let below = vec3<i32>(cell < vec3<i32>(0));
  let above = vec3<i32>(cell >= voxc_r4_4_4_g8_VOLUME_SIZE);
  let enters = below * (vec3<i32>((*ray).moves) - vec3<i32>((*ray).falls)) + above * vec3<i32>((*ray).falls);
  traversal.cell = cell;
  if (all(enters == vec3<i32>(0)) || any(enters != below + above)) {
    return traversal;
  }
  let face = select(vec3<i32>(0), voxc_r4_4_4_g8_VOLUME_SIZE, (*ray).falls);
  let axis = voxc_r4_4_4_g8_last_entered(*ray, enters > vec3<i32>(0), face);
  if (starts_far) {
    voxc_r4_4_4_g8_start_at(ray, cell, axis, face[axis]);
  }
  return voxc_r4_4_4_g8_behind_face(*ray, traversal, cell, axis, face[axis]);
}

// The same by float32 or doubles, of an ordinary ray: it passes the last of these faces, or is past all of them. Not
// sure if that cannot decide which face is the last, or which cell is behind it.
fn voxc_r4_4_4_g8_entered(ray: voxc_r4_4_4_g8_Ray, given_traversal: voxc_r4_4_4_g8_Traversal, face: vec3<f32>,
    sure: ptr<function, bool>) -> voxc_r4_4_4_g8_Traversal {
  var traversal: voxc_r4_4_4_g8_Traversal = given_traversal;
  let LATEST = 281474976710656.0f; // 2^48: a ray of a voxel a moment is past the volume by then, whatever enters last.
  // A coordinate that never changes stays outside.
  var t: vec3<f32> = select(vec3<f32>(-1.0f), voxc_r4_4_4_g8_times_of(ray, face), ray.moves);
  let is_as_given = ray.t_error == 0.0f; // Else it has come near, and does not begin here.
  // From a last face, which is not in the volume, a ray enters at 0; its t is a 0 with a sign.
  let last_face = select(vec3<f32>(voxc_r4_4_4_g8_NEVER), face, ray.falls);
  let on_face = ray.origin == select(vec3<f32>(voxc_r4_4_4_g8_NEVER), last_face, is_as_given);
  t = select(t, vec3<f32>(0.0f), on_face);
  let latest = min(voxc_r4_4_4_g8_greatest_of(t), LATEST);
  let before = voxc_r4_4_4_g8_second_least_of(t);
  let passed = t == vec3<f32>(latest);
  let begins_here = !(latest > 0.0f) && is_as_given && !any(on_face);
  var point: vec3<f32> = select(ray.origin_low + latest * ray.direction, face + ray.beyond, passed);
  point = select(point, ray.origin, begins_here);
  let whole = floor(point);
  let is_last = before < latest - (latest * voxc_r4_4_4_g8_ROUNDINGS + ray.t_error);
  let is_certain = voxc_r4_4_4_g8_greatest_of(point - whole) < ray.cell_margin;
  let is_sure = begins_here || (is_last && is_certain);
  *sure = *sure && is_sure;
  traversal.cell = vec3<i32>(clamp(whole, vec3<f32>(-1.0f), vec3<f32>(4194304.0f)));
  traversal.axis = select(select(select(2, 1, passed.y), 0, passed.x), -1, begins_here);
  return traversal;
}

// Puts the traversal into the first cell of the volume on the ray; false if there is none, or if the ray is left.
fn voxc_r4_4_4_g8_enter_volume(ray: ptr<function, voxc_r4_4_4_g8_Ray>, traversal: ptr<function,
    voxc_r4_4_4_g8_Traversal>, ordinary: bool) -> bool {
  let face = select(vec3<f32>(0.0f), vec3<f32>(voxc_r4_4_4_g8_VOLUME_SIZE), (*ray).falls);
  let cell = floor((*ray).origin);
  var near: voxc_r4_4_4_g8_Start = voxc_r4_4_4_g8_come_near(ray);
  if (!ordinary && any(voxc_r4_4_4_g8_starts_tiny(*ray))) {
    near.t_error = voxc_r4_4_4_g8_NEVER;
  }
  voxc_r4_4_4_g8_bound_errors(ray, cell, near.wrong, near.t_error);
  let has_begun = voxc_r4_4_4_g8_is_in_volume((*traversal).cell) || ((*traversal).pending_step >= 0);
  if (has_begun && !near.is_far) {
    return true; // Where it has entered need not be found again.
  }
  var sure: bool = ordinary && !near.is_far;
  var start: voxc_r4_4_4_g8_Traversal = voxc_r4_4_4_g8_entered(*ray, *traversal, face, &sure);
  if (!sure) {
    // What a function may change by reference stands in memory; the ray itself need not.
    var moved: voxc_r4_4_4_g8_Ray = *ray;
    start = voxc_r4_4_4_g8_entered_exactly(&moved, *traversal, near.is_far);
    *ray = moved;
  }
  *traversal = start;
  return voxc_r4_4_4_g8_is_in_volume((*traversal).cell);
}

// A ray as given, made ready for the traversal.

const voxc_r4_4_4_g8_LEAST_COMPONENT: f32 = 1.0f / 1099511627776.0f / 1099511627776.0f; // 2^-80.

// Most rays are ordinary: float32 traverses with them as they are, and nothing overflows or is lost on the way. Their
// direction is scaled without a rounding, all numbers of theirs are then 0 or at least 2^-80, and they begin within
// 2^45 voxels, or near the volume if rays from far away are not moved. `longest` has the bits of the direction's
// longest component, and `component` is the direction once it is scaled.
fn voxc_r4_4_4_g8_is_ordinary(origin: vec3<u32>, longest: u32, component: vec3<f32>) -> bool {
  let SHORTEST = 0x00800000u; // The bits of 2^-126, below which devices may keep no number.
  let RANGE = 0x7e800000u; // From there to 2^127, where no number is left to scale by.
  let place = origin & vec3<u32>(~voxc_r4_4_4_g8_SIGN_BIT);
  let least = min(place - 1u, bitcast<vec3<u32>>(abs(component)));
  let farthest = max(max(place.x, place.y), place.z);
  let is_scaled = longest - SHORTEST < RANGE;
  let is_large = min(min(least.x, least.y), least.z) >= bitcast<u32>(voxc_r4_4_4_g8_LEAST_COMPONENT);
  let is_near = farthest < bitcast<u32>(voxc_r4_4_4_g8_far_away());
  return is_scaled && is_large && is_near;
}

// The magnitudes of a direction, divided by a power of two that leaves the largest in [1, 2), for numbers of any size.
fn voxc_r4_4_4_g8_scaled_exactly(size: vec3<u32>) -> vec3<f32> {
  var exponent: vec3<i32>;
  var largest: i32 = -1000;
  for (var axis: i32 = 0; axis < 3; axis++) {
    let significand = voxc_r4_4_4_g8_significand_of(size[axis]);
    exponent[axis] = voxc_r4_4_4_g8_exponent_of(size[axis]) + i32(firstLeadingBit(significand));
    largest = select(largest, max(largest, exponent[axis]), significand != 0u);
  }
  var result: vec3<f32>;
  for (var axis: i32 = 0; axis < 3; axis++) {
    let significand = voxc_r4_4_4_g8_significand_of(size[axis]);
    result[axis] = f32(significand) * voxc_r4_4_4_g8_power_of_two(-i32(firstLeadingBit(significand)))
        * voxc_r4_4_4_g8_power_of_two(max(exponent[axis] - largest, -60));
  }
  return result;
}

// Makes a ray ready, whose direction is scaled by a power of two so that its longest component is in [1, 2).
fn voxc_r4_4_4_g8_prepare_ray(origin: vec3<u32>, direction: vec3<u32>, ordinary: ptr<function,
    bool>) -> voxc_r4_4_4_g8_Ray {
  var ray: voxc_r4_4_4_g8_Ray;
  ray.given_origin = origin;
  ray.given_direction = direction;
  let size = direction & vec3<u32>(~voxc_r4_4_4_g8_SIGN_BIT);
  let longest = voxc_r4_4_4_g8_longest_of(direction);
  ray.moves = size != vec3<u32>(0u);
  var component: vec3<f32> = bitcast<vec3<f32>>(direction) * bitcast<f32>(0x7f000000u
      - (longest & voxc_r4_4_4_g8_INFINITY_BITS));
  component = select(vec3<f32>(voxc_r4_4_4_g8_LEAST_COMPONENT), component, ray.moves);
  *ordinary = voxc_r4_4_4_g8_is_ordinary(origin, longest, component);
  ray.plain = *ordinary;
  if (!*ordinary) {
    ray.plain = voxc_r4_4_4_g8_are_plain(origin) && voxc_r4_4_4_g8_are_plain(direction);
    component = select(vec3<f32>(1.0f), vec3<f32>(-1.0f),
        direction > vec3<u32>(voxc_r4_4_4_g8_SIGN_BIT)) * voxc_r4_4_4_g8_scaled_exactly(size);
    component = select(vec3<f32>(voxc_r4_4_4_g8_LEAST_COMPONENT), component, ray.moves);
  }
  let sign = bitcast<vec3<i32>>(component) >> vec3<u32>(31u);
  ray.origin = bitcast<vec3<f32>>(origin);
  ray.direction = component;
  ray.inverse = 1.0f / ray.direction;
  ray.late = vec3<f32>(0.0f);
  ray.falls = sign < vec3<i32>(0);
  ray.heading = sign | vec3<i32>(1);
  ray.beyond = vec3<f32>(sign);
  ray.ahead = ~sign;
  return ray;
}

// From a ray to its traversal, and the end of the traversal.

// A ray that goes nowhere can hit its own cell alone: it is let go anywhere, and takes no later hit.
fn voxc_r4_4_4_g8_goes_nowhere(direction: vec3<u32>) -> bool {
  return ((direction.x | direction.y | direction.z) & ~voxc_r4_4_4_g8_SIGN_BIT) == 0u;
}

// Makes a ray ready, and its traversal too, if that has not begun. False if there is nothing to go through, or if the
// ray is left.
fn voxc_r4_4_4_g8_begin_traversal(origin: vec3<u32>, direction: vec3<u32>, root: u32, ray: ptr<function,
    voxc_r4_4_4_g8_Ray>, traversal: ptr<function, voxc_r4_4_4_g8_Traversal>) -> bool {
  let stays = voxc_r4_4_4_g8_goes_nowhere(direction);
  var ordinary: bool;
  *ray = voxc_r4_4_4_g8_prepare_ray(origin, select(direction, vec3<u32>(bitcast<u32>(1.0f), 0u, 0u), stays), &ordinary);
  if (root == 0u) {
    return false;
  }
  if (!(voxc_r4_4_4_g8_are_finite(origin) && voxc_r4_4_4_g8_are_finite(direction))) {
    return false;
  }
  var start: voxc_r4_4_4_g8_Traversal = *traversal;
  let enters = voxc_r4_4_4_g8_enter_volume(ray, &start, ordinary);
  let may_have_begun = true; // A dispatch without the exact fallback begins all its rays.
  let has_begun = may_have_begun && (voxc_r4_4_4_g8_is_in_volume((*traversal).cell)
      || ((*traversal).pending_step != voxc_r4_4_4_g8_NO_PENDING_STEP));
  if (!enters || !has_begun) {
    *traversal = start;
  }
  return enters;
}

// What becomes of a hit: a ray that goes nowhere loses what is not in its own cell, once its traversal has begun.
fn voxc_r4_4_4_g8_end_traversal(origin: vec3<u32>, direction: vec3<u32>, traversal: ptr<function,
    voxc_r4_4_4_g8_Traversal>, hit: bool) -> bool {
  let may_stay = true; // Packets go on with rays that exact arithmetic has prepared.
  if (!may_stay || !voxc_r4_4_4_g8_goes_nowhere(direction) || ((*traversal).pending_step == voxc_r4_4_4_g8_RETRY)
      || all((*traversal).cell == voxc_r4_4_4_g8_floor_of(origin))) {
    return hit;
  }
  (*traversal).cell = vec3<i32>(-1);
  (*traversal).pending_step = voxc_r4_4_4_g8_NO_PENDING_STEP;
  return false;
}

// The t of a face, correctly rounded, in integers.

// An unsigned number of 64 bits.
struct voxc_r4_4_4_g8_Wide {
  high: u32,
  low: u32,
}

fn voxc_r4_4_4_g8_is_below(a: voxc_r4_4_4_g8_Wide, b: voxc_r4_4_4_g8_Wide) -> bool {
  return (a.high < b.high) || (a.high == b.high && a.low < b.low);
}

fn voxc_r4_4_4_g8_sum_of(a: voxc_r4_4_4_g8_Wide, b: voxc_r4_4_4_g8_Wide) -> voxc_r4_4_4_g8_Wide {
  var carry: u32;
  let low = voxc_r4_4_4_g8_uaddCarry(a.low, b.low, &carry);
  return voxc_r4_4_4_g8_Wide(a.high + b.high + carry, low);
}

fn voxc_r4_4_4_g8_difference_of(a: voxc_r4_4_4_g8_Wide, b: voxc_r4_4_4_g8_Wide) -> voxc_r4_4_4_g8_Wide {
  var borrow: u32;
  let low = voxc_r4_4_4_g8_usubBorrow(a.low, b.low, &borrow);
  return voxc_r4_4_4_g8_Wide(a.high - b.high - borrow, low);
}

fn voxc_r4_4_4_g8_log2_of_wide(number: voxc_r4_4_4_g8_Wide) -> i32 {
  return select(i32(firstLeadingBit(number.low)), 32 + i32(firstLeadingBit(number.high)), number.high != 0u);
}

// number * 2^shift, shift in [-63, 63]. Bits that fall off the low end are told of; none falls off the high end.
fn voxc_r4_4_4_g8_shifted(number: voxc_r4_4_4_g8_Wide, shift: i32, inexact: ptr<function,
    bool>) -> voxc_r4_4_4_g8_Wide {
  var right: i32 = max(-shift, 0);
  var left: i32 = max(shift, 0);
  var high: u32 = number.high;
  var low: u32 = number.low;
  if (right >= 32) {
    *inexact = *inexact || (low != 0u);
    low = high;
    high = 0u;
    right -= 32;
  } else if (left >= 32) {
    high = low;
    low = 0u;
    left -= 32;
  }
  if (right > 0) {
    *inexact = *inexact || ((low & ((1u << u32(right)) - 1u)) != 0u);
    low = (low >> u32(right)) | (high << u32(32 - right));
    high >>= u32(right);
  } else if (left > 0) {
    high = (high << u32(left)) | (low >> u32(32 - left));
    low <<= u32(left);
  }
  return voxc_r4_4_4_g8_Wide(high, low);
}

// A number of 50 bits, times 2^exponent.
struct voxc_r4_4_4_g8_Distance {
  number: voxc_r4_4_4_g8_Wide,
  exponent: i32,
  inexact: bool, // The exact distance is a little more.
}

// |face - origin|, its leading 50 bits.
fn voxc_r4_4_4_g8_distance_to(face: u32, origin: u32) -> voxc_r4_4_4_g8_Distance {
  let significand = voxc_r4_4_4_g8_significand_of(origin);
  let exponent = voxc_r4_4_4_g8_exponent_of(origin) - 150;
  // The larger of the two has its first bit at place 61, and so none below place 0.
  let top = max(select(i32(firstLeadingBit(face)), -1000, face == 0u),
      select(exponent + i32(firstLeadingBit(significand)), -1000, significand == 0u));
  var distance: voxc_r4_4_4_g8_Distance = voxc_r4_4_4_g8_Distance(voxc_r4_4_4_g8_Wide(0u, 0u), 0, false);
  var a: voxc_r4_4_4_g8_Wide = voxc_r4_4_4_g8_shifted(voxc_r4_4_4_g8_Wide(0u, face), clamp(61 - top, -63, 63),
      &distance.inexact);
  let b = voxc_r4_4_4_g8_shifted(voxc_r4_4_4_g8_Wide(0u, significand), clamp(61 - top + exponent, -63, 63),
      &distance.inexact);
  if (origin >= voxc_r4_4_4_g8_SIGN_BIT) {
    a = voxc_r4_4_4_g8_sum_of(a, b);
  } else {
    if (voxc_r4_4_4_g8_is_below(a, b)) {
      a = voxc_r4_4_4_g8_difference_of(b, a);
    } else {
      a = voxc_r4_4_4_g8_difference_of(a, b);
    }
    // What fell off was to be taken away.
    if (distance.inexact) {
      a = voxc_r4_4_4_g8_difference_of(a, voxc_r4_4_4_g8_Wide(0u, 1u));
    }
  }
  let place = voxc_r4_4_4_g8_log2_of_wide(a) - 49;
  distance.number = voxc_r4_4_4_g8_shifted(a, -place, &distance.inexact);
  distance.exponent = top - 61 + place;
  return distance;
}

// value * 2^exponent of a value below 2^27, rounded to the nearest float32, ties to even; `inexact` if it is a little
// more.
fn voxc_r4_4_4_g8_rounded(value: u32, exponent: i32, inexact: bool) -> u32 {
  let log2_value = i32(firstLeadingBit(value)) + exponent;
  if (log2_value > 127) {
    return voxc_r4_4_4_g8_INFINITY_BITS;
  }
  let drop = min(i32(firstLeadingBit(value)) - 23 + max(-126 - log2_value, 0), 31);
  var kept: u32 = value >> u32(drop);
  let rest = value & ((1u << u32(drop)) - 1u);
  let middle = 1u << u32(drop - 1);
  if ((rest > middle) || (rest == middle && (inexact || ((kept & 1u) != 0u)))) {
    kept++;
  }
  return min((u32(max(log2_value + 126, 0)) << 23u) + kept, voxc_r4_4_4_g8_INFINITY_BITS);
}

// When the ray passes a face ahead of its origin: |face - origin| / |direction|, as bits of float32.
fn voxc_r4_4_4_g8_time_exactly(ray: voxc_r4_4_4_g8_Ray, axis: i32, face: i32) -> u32 {
  let distance = voxc_r4_4_4_g8_distance_to(u32(face), ray.given_origin[axis]);
  if (distance.number.high == 0u) {
    return 0u;
  }
  var divisor: u32 = voxc_r4_4_4_g8_significand_of(ray.given_direction[axis]);
  let shift = 23 - i32(firstLeadingBit(divisor));
  divisor <<= u32(shift);
  // The quotient, below 2^27, by an estimate that an exact remainder corrects: what float32 rounds leaves it wrong by
  // less than 100, so the remainder fits 32 bits; the quotient of that is wrong by 1 at most.
  let size = f32(divisor);
  let estimate = (f32(distance.number.high) * 4294967296.0f + f32(distance.number.low)) / size;
  var value: u32 = u32(estimate);
  var high: u32; var low: u32;
  voxc_r4_4_4_g8_umulExtended(value, divisor, &high, &low);
  var rest: i32 = i32(distance.number.low - low);
  let more = i32(floor(f32(rest) / size));
  rest -= more * i32(divisor);
  let last = select(select(0, 1, rest >= i32(divisor)), -1, rest < 0);
  value += u32(more + last);
  rest -= last * i32(divisor);
  let exponent = distance.exponent - (voxc_r4_4_4_g8_exponent_of(ray.given_direction[axis]) - 150 - shift);
  return voxc_r4_4_4_g8_rounded(value, exponent, distance.inexact || (rest != 0));
}

// The same, as fast as it can be told. Where a device promises little of its arithmetic, integers tell it of every hit:
// a dispatch that does not resolve would defer each of them to one with it.
fn voxc_r4_4_4_g8_crossing_time(ray: voxc_r4_4_4_g8_Ray, axis: i32, face: i32, sure: ptr<function, bool>) -> u32 {
  *sure = false;
  var bits: u32 = 0u;
  if (!*sure) {
    bits = voxc_r4_4_4_g8_time_exactly(ray, axis, face);
    *sure = true;
  }
  return bits;
}

// The face through which the ray entered its cell.
fn voxc_r4_4_4_g8_entered_face(ray: voxc_r4_4_4_g8_Ray, traversal: voxc_r4_4_4_g8_Traversal) -> i32 {
  return traversal.cell[traversal.axis] + select(0, 1, ray.falls[traversal.axis]);
}

// How a ray comes to the voxel that it hits.
struct voxc_r4_4_4_g8_Arrival {
  t: u32,    // The bits of a float32.
  face: u32, // Twice the axis on which the ray enters, and 1 more where its coordinate falls.
}

const voxc_r4_4_4_g8_BEGINS_INSIDE: u32 = 6u; // No face.

// True if the ray comes into its cell on two axes at one moment.
fn voxc_r4_4_4_g8_enters_together(ray: voxc_r4_4_4_g8_Ray, face: vec3<i32>, a: i32, b: i32) -> bool {
  return ray.moves[a] && ray.falls[a] == ray.falls[b] && voxc_r4_4_4_g8_compare_crossings(ray, a, face[a], b,
      face[b]) == 0;
}

// The first axis on which the ray comes into the traversal's cell as it enters that. Not sure if steps cannot decide.
// Without exactness, of several, at an edge, the one that the traversal has met.
fn voxc_r4_4_4_g8_first_axis(ray: voxc_r4_4_4_g8_Ray, traversal: voxc_r4_4_4_g8_Traversal, sure: ptr<function,
    bool>) -> i32 {
  *sure = true;
  var first: i32 = traversal.axis;
  let face = traversal.cell + vec3<i32>(ray.falls);
  let t = voxc_r4_4_4_g8_times_of(ray, vec3<f32>(face));
  for (var axis: i32 = 0; axis < 2; axis++) {
    let apart = abs(t[axis] - t[traversal.axis]);
    let bound = min(abs(t[axis]), abs(t[traversal.axis])) * voxc_r4_4_4_g8_ROUNDINGS + ray.t_error;
    if (axis < first && ray.moves[axis] && ray.falls[axis] == ray.falls[traversal.axis] && !(apart > bound)) {
      *sure = false;
    }
  }
  if (!*sure) {
    *sure = true;
    for (var axis: i32 = 1; axis >= 0; axis--) {
      first = select(first, axis, axis < traversal.axis && voxc_r4_4_4_g8_enters_together(ray, face, axis,
          traversal.axis));
    }
  }
  return first;
}

// How the ray came to the traversal's cell. Not sure where float32 or doubles cannot decide.
fn voxc_r4_4_4_g8_arrival_at(ray: voxc_r4_4_4_g8_Ray, traversal: voxc_r4_4_4_g8_Traversal, hit: bool,
    sure: ptr<function, bool>) -> voxc_r4_4_4_g8_Arrival {
  var arrival: voxc_r4_4_4_g8_Arrival;
  arrival.t = 0u;
  arrival.face = voxc_r4_4_4_g8_BEGINS_INSIDE;
  *sure = true;
  if (!hit || (traversal.axis < 0)) {
    return arrival;
  }
  arrival.t = voxc_r4_4_4_g8_crossing_time(ray, traversal.axis, voxc_r4_4_4_g8_entered_face(ray, traversal), sure);
  var sure_of_axis: bool;
  let axis = voxc_r4_4_4_g8_first_axis(ray, traversal, &sure_of_axis);
  arrival.face = 2u * u32(axis) + u32(ray.falls[axis]);
  *sure = *sure && sure_of_axis;
  return arrival;
}

// A single voxel: the traversal has arrived.
fn voxc_r4_4_4_g8_intersect_voxel(traversal: ptr<function, voxc_r4_4_4_g8_Traversal>, voxel: u32) -> bool {
  (*traversal).voxel = voxel;
  return true;
}

// ---- The format: R(4, 4, 4) G(8) ----

// Which child of a node a place lies in, counted in children.
fn voxc_r4_4_4_g8_child_index(place: vec3<i32>) -> i32 {
  let bits = place & vec3<i32>(1);
  return bits.x | (bits.y << 1u) | (bits.z << 2u);
}

// Level 2: svdag, 256 x 256 x 256 cells of 1 voxel a side.
const voxc_r4_4_4_g8_LEVEL_2_DEPTH: i32 = 8;
const voxc_r4_4_4_g8_LEVEL_2_LOG2_CELL: i32 = 0;
const voxc_r4_4_4_g8_LEVEL_2_LOG2_SIDE: i32 = 8;

// A node is [masks, slots of its children...]: a bit for each child that is not empty, one for each that is a leaf, and
// slots of those that are not empty or, where all leaves have one value, that are neither empty nor leaves. Gives the
// child of a node that a cell lies in, or 0 if it is empty; the child has 2^height cells a side.
fn voxc_r4_4_4_g8_child_level_2(volume: u32, node: u32, cell: vec3<i32>, height: i32, leaf: ptr<function,
    bool>) -> u32 {
  let child = voxc_r4_4_4_g8_child_index(cell >> vec3<u32>(u32(height)));
  let masks = voxc_r4_4_4_g8_load_word(volume, node);
  *leaf = ((masks >> u32(8 + child)) & 1u) != 0u;
  if (((masks >> u32(child)) & 1u) == 0u) {
    return 0u;
  }
  return voxc_r4_4_4_g8_load_word(volume, node + 1u + countOneBits(masks & ((1u << u32(child)) - 1u)));
}

// path[i] is the node i layers above the cells around the traversal's cell: a step climbs only to the ancestor of the
// old cell and the new.
fn voxc_r4_4_4_g8_intersect_level_2(volume: u32, ray: voxc_r4_4_4_g8_Ray, traversal: ptr<function,
    voxc_r4_4_4_g8_Traversal>, root: u32) -> bool {
  var path: array<u32, voxc_r4_4_4_g8_LEVEL_2_DEPTH + 1>;
  path[voxc_r4_4_4_g8_LEVEL_2_DEPTH] = root;
  var top: i32 = voxc_r4_4_4_g8_LEVEL_2_DEPTH;
  for (;;) {
    let cell = (*traversal).cell >> vec3<u32>(u32(voxc_r4_4_4_g8_LEVEL_2_LOG2_CELL));
    var node: u32 = path[top];
    var layer: i32 = top;
    var leaf: bool = false;
    while (node != 0u && !leaf) {
      path[layer] = node;
      layer--;
      node = voxc_r4_4_4_g8_child_level_2(volume, node, cell, layer, &leaf);
    }
    let before = (*traversal).cell;
    if (node == 0u) {
      voxc_r4_4_4_g8_step_over_int(ray, traversal, voxc_r4_4_4_g8_LEVEL_2_LOG2_CELL + layer);
    } else if (leaf && voxc_r4_4_4_g8_intersect_voxel(traversal, node)) {
      return true;
    }
    let changed = before ^ (*traversal).cell;
    let highest = i32(firstLeadingBit(u32(changed.x | changed.y | changed.z)));
    if (highest >= voxc_r4_4_4_g8_LEVEL_2_LOG2_SIDE) {
      return false;
    }
    top = max(layer, highest - voxc_r4_4_4_g8_LEVEL_2_LOG2_CELL) + 1;
  }
}

// Level 1: raw, 16 x 16 x 16 cells of 256 voxels a side.
const voxc_r4_4_4_g8_LEVEL_1_LOG2_SIZE: vec3<i32> = vec3<i32>(4, 4, 4);
const voxc_r4_4_4_g8_LEVEL_1_LOG2_CELL: i32 = 8;

// A grid has a slot a cell, x fastest, then y, then z.
// The place of a cell's slot: in that granule, where references count granules.
fn voxc_r4_4_4_g8_slot_level_1(grid: u32, cell: vec3<i32>) -> u32 {
  let at = cell;
  return grid + u32(at.x + ((at.y
      + (at.z << u32(voxc_r4_4_4_g8_LEVEL_1_LOG2_SIZE.y))) << u32(voxc_r4_4_4_g8_LEVEL_1_LOG2_SIZE.x)));
}

// The value of a cell, or 0 if it is empty.
fn voxc_r4_4_4_g8_cell_level_1(volume: u32, grid: u32, cell: vec3<i32>) -> u32 {
  let slot = voxc_r4_4_4_g8_slot_level_1(grid, cell);
  return voxc_r4_4_4_g8_load_word(volume, slot);
}

fn voxc_r4_4_4_g8_intersect_level_1(volume: u32, ray: voxc_r4_4_4_g8_Ray, traversal: ptr<function,
    voxc_r4_4_4_g8_Traversal>, grid: u32) -> bool {
  while (voxc_r4_4_4_g8_goes_on(*traversal)) {
    let span = voxc_r4_4_4_g8_EmptySpan(voxc_r4_4_4_g8_LEVEL_1_LOG2_CELL, 1);
    let value = voxc_r4_4_4_g8_cell_level_1(volume, grid,
        (*traversal).cell >> vec3<u32>(u32(voxc_r4_4_4_g8_LEVEL_1_LOG2_CELL)));
    if (value == 0u) {
      voxc_r4_4_4_g8_step_over_emptyspan(ray, traversal, span);
    } else if (voxc_r4_4_4_g8_intersect_level_2(volume, ray, traversal, value)) {
      return true;
    }
  }
  return false;
}

// What a voxel is: here its value is its colour.
fn voxc_r4_4_4_g8_colour_of(volume: u32, traversal: voxc_r4_4_4_g8_Traversal) -> u32 {
  return voxc_r4_4_4_g8_load_word(volume, traversal.voxel);
}

// ---- What follows is the same in every kernel ----

// Goes on with a traversal to its end, or until it is left.
fn voxc_r4_4_4_g8_continue_traversal(volume: u32, ray: voxc_r4_4_4_g8_Ray, traversal: ptr<function,
    voxc_r4_4_4_g8_Traversal>, root: u32) -> bool {
  var hit: bool = false;
  var is_under_way: bool = true;
  while (is_under_way) {
    while ((*traversal).pending_step >= 0) {
      voxc_r4_4_4_g8_resolve_step(ray, traversal);
    }
    // What was resolved may have been the last step inside.
    hit = voxc_r4_4_4_g8_is_in_volume((*traversal).cell) && voxc_r4_4_4_g8_intersect_level_1(volume, ray, traversal,
        root);
    is_under_way = (*traversal).pending_step >= 0;
  }
  return hit;
}

// What lies between two moments of a ray, tmin and tmax.

// Moments as bits of float32 that are not below 0. Nothing lies between them if tmin > tmax.
struct voxc_r4_4_4_g8_Bounds {
  tmin: u32,
  tmax: u32,
}

// The bits of a moment, for which one before 0 is as good as 0.
fn voxc_r4_4_4_g8_moment_of(bits: u32) -> u32 {
  return select(bits & ~voxc_r4_4_4_g8_SIGN_BIT, 0u, bits > voxc_r4_4_4_g8_SIGN_BIT && bits <= (voxc_r4_4_4_g8_SIGN_BIT
      | voxc_r4_4_4_g8_INFINITY_BITS));
}

// The bounds that two float32 tell. A NaN is in no interval, and no voxel is entered at +inf.
fn voxc_r4_4_4_g8_bounds_between(tmin: u32, tmax: u32) -> voxc_r4_4_4_g8_Bounds {
  var bounds: voxc_r4_4_4_g8_Bounds = voxc_r4_4_4_g8_Bounds(voxc_r4_4_4_g8_moment_of(tmin),
      voxc_r4_4_4_g8_moment_of(tmax));
  let are_bounds = bounds.tmin < voxc_r4_4_4_g8_INFINITY_BITS && tmax <= voxc_r4_4_4_g8_SIGN_BIT
      && bounds.tmax <= voxc_r4_4_4_g8_INFINITY_BITS;
  if (!are_bounds) {
    bounds = voxc_r4_4_4_g8_Bounds(1u, 0u);
  }
  return bounds;
}

const voxc_r4_4_4_g8_UNDECIDED: i32 = 2; // No order: it cannot be told here.

// The order of the moment at which a coordinate passes a face and another moment, where
// (face - origin) * 1 - moment * direction has this sign.
fn voxc_r4_4_4_g8_order_by_sign(ray: voxc_r4_4_4_g8_Ray, axis: i32, sign_of_difference: i32) -> i32 {
  return select(sign_of_difference, -sign_of_difference, ray.falls[axis]);
}

fn voxc_r4_4_4_g8_compare_moment_exactly(ray: voxc_r4_4_4_g8_Ray, axis: i32, face: i32, moment: u32) -> i32 {
  let one = bitcast<u32>(1.0f);
  let difference = voxc_r4_4_4_g8_sum_of_products(vec4<u32>(bitcast<u32>(f32(face)),
      ray.given_origin[axis] ^ voxc_r4_4_4_g8_SIGN_BIT, moment ^ voxc_r4_4_4_g8_SIGN_BIT, 0u), vec4<u32>(one, one,
      ray.given_direction[axis], 0u));
  return voxc_r4_4_4_g8_order_by_sign(ray, axis, voxc_r4_4_4_g8_sign_of(difference));
}

// What is known of the order of two moments: that one is later or sooner, or, of neither, that they are the same.
fn voxc_r4_4_4_g8_order_decided(ray: voxc_r4_4_4_g8_Ray, axis: i32, moment: u32, later: bool, sooner: bool,
    is_exact: bool) -> i32 {
  // Devices may not keep a denormal moment.
  let decided = (later || sooner || is_exact) && ray.plain && moment - 1u >= 0x7fffffu;
  if (decided) {
    return voxc_r4_4_4_g8_order_by_sign(ray, axis, select(select(0, -1, sooner), 1, later));
  }
  return voxc_r4_4_4_g8_UNDECIDED;
}

// The same by float32, whose distance and way are rounded once each.
fn voxc_r4_4_4_g8_compare_moment_by_floats(ray: voxc_r4_4_4_g8_Ray, axis: i32, face: i32, moment: u32) -> i32 {
  let distance = f32(face) - bitcast<f32>(ray.given_origin[axis]);
  let way = bitcast<f32>(moment) * bitcast<f32>(ray.given_direction[axis]);
  let bound = (abs(distance) + abs(way)) * voxc_r4_4_4_g8_ROUNDINGS;
  return voxc_r4_4_4_g8_order_decided(ray, axis, moment, distance - way > bound, distance - way < -bound, false);
}

fn voxc_r4_4_4_g8_compare_moment(ray: voxc_r4_4_4_g8_Ray, axis: i32, face: i32, moment: u32) -> i32 {
  return voxc_r4_4_4_g8_compare_moment_by_floats(ray, axis, face, moment);
}

// Whether the ray enters the traversal's cell before a moment, -1, at it, 0, or after it, 1. UNDECIDED if only exact
// arithmetic can tell, and that is not at hand, or the device has cut it short.
fn voxc_r4_4_4_g8_compare_entry(ray: voxc_r4_4_4_g8_Ray, traversal: voxc_r4_4_4_g8_Traversal, moment: u32) -> i32 {
  if (traversal.axis < 0) {
    return select(-1, 0, moment == 0u);
  }
  let face = voxc_r4_4_4_g8_entered_face(ray, traversal);
  var order: i32 = voxc_r4_4_4_g8_compare_moment(ray, traversal.axis, face, moment);
  if (order == voxc_r4_4_4_g8_UNDECIDED) {
    order = voxc_r4_4_4_g8_compare_moment_exactly(ray, traversal.axis, face, moment);
  }
  return order;
}

// Where the entry of the traversal's cell lies: before the bounds, -1, within them, 0, or after them, 1. UNDECIDED as
// above.
fn voxc_r4_4_4_g8_place_of_entry(ray: voxc_r4_4_4_g8_Ray, traversal: voxc_r4_4_4_g8_Traversal,
    bounds: voxc_r4_4_4_g8_Bounds) -> i32 {
  var order: i32;
  if (bounds.tmin == 0u) {
    order = 0;
  } else {
    order = voxc_r4_4_4_g8_compare_entry(ray, traversal, bounds.tmin);
  }
  if ((order < 0) || (order == voxc_r4_4_4_g8_UNDECIDED)) {
    return order;
  }
  if (bounds.tmax == voxc_r4_4_4_g8_INFINITY_BITS) {
    return 0;
  }
  return max(voxc_r4_4_4_g8_compare_entry(ray, traversal, bounds.tmax), 0);
}

// Where a ray is at a moment, wrong by less than `wrong` and a rounding of it.
struct voxc_r4_4_4_g8_Place {
  at: vec3<f32>,
  wrong: vec3<f32>,
  is_known: bool, // It is not out of float32's reach.
}

// From any distance, as rays come near (near.glsl): with halves of 12 bits no product is rounded, and their sum with
// the origin is kept as two float32, of which the lower one loses less than 2^-43 of the way and the distance. Where
// rays do not come near, as nearly all begin there, or as a language has no `precise`, it is one float32.
fn voxc_r4_4_4_g8_place_at(ray: voxc_r4_4_4_g8_Ray, moment: u32) -> voxc_r4_4_4_g8_Place {
  let origin = bitcast<vec3<f32>>(ray.given_origin);
  let direction = bitcast<vec3<f32>>(ray.given_direction);
  let t = bitcast<f32>(moment);
  let way = t * direction;
  let reach = abs(origin) + abs(way);
  let is_known = all(reach < vec3<f32>(voxc_r4_4_4_g8_NEVER));
  return voxc_r4_4_4_g8_Place(origin + way, reach / 1048576.0f, is_known); // 2^20.
}

// Moves a traversal that begins long before a moment to a cell that the ray comes to shortly before.
fn voxc_r4_4_4_g8_skip_to(ray: voxc_r4_4_4_g8_Ray, traversal: ptr<function, voxc_r4_4_4_g8_Traversal>, moment: u32) {
  let WORTH_SKIPPING = 4; // In voxels.
  if ((moment == 0u) || !voxc_r4_4_4_g8_is_in_volume((*traversal).cell)) {
    return;
  }
  let size = ray.given_direction & vec3<u32>(~voxc_r4_4_4_g8_SIGN_BIT);
  let axis = select(select(2, 1, size.y >= size.z), 0, size.x >= max(size.y, size.z));
  let place = voxc_r4_4_4_g8_place_at(ray, moment);
  if (!place.is_known) {
    return;
  }
  let before = place.at[axis] - f32(ray.heading[axis]) * (2.0f + place.wrong[axis]); // By more than a few roundings.
  let face = i32(floor(clamp(before, -1.0f, f32(voxc_r4_4_4_g8_VOLUME_SIZE[axis] + 1))));
  let behind = face - i32(ray.falls[axis]);
  if ((behind - (*traversal).cell[axis]) * ray.heading[axis] > WORTH_SKIPPING) {
    *traversal = voxc_r4_4_4_g8_behind_face(ray, *traversal, (*traversal).cell, axis, face);
  }
}

// Lets a traversal end shortly after a moment, where float32 can decide when that is.
fn voxc_r4_4_4_g8_end_after(ray: voxc_r4_4_4_g8_Ray, traversal: ptr<function, voxc_r4_4_4_g8_Traversal>, moment: u32) {
  if (!ray.plain || (moment >= voxc_r4_4_4_g8_INFINITY_BITS) || (moment != 0u && moment < 0x800000u)) {
    return;
  }
  let place = voxc_r4_4_4_g8_place_at(ray, moment);
  if (!place.is_known) {
    return;
  }
  let after = place.at + vec3<f32>(ray.heading) * (2.0f + place.wrong);
  let last = vec3<i32>(clamp(floor(after), vec3<f32>(0.0f), vec3<f32>(voxc_r4_4_4_g8_VOLUME_SIZE - 1)));
  (*traversal).begin = select(vec3<i32>(0), last, ray.falls);
  (*traversal).size = select(voxc_r4_4_4_g8_VOLUME_SIZE, last + 1, ray.heading > vec3<i32>(0)) - (*traversal).begin;
}

// Lets a traversal that is ready end shortly after its bounds. False, and a miss, if nothing lies between them.
fn voxc_r4_4_4_g8_bound_traversal(ray: voxc_r4_4_4_g8_Ray, traversal: ptr<function, voxc_r4_4_4_g8_Traversal>,
    bounds: voxc_r4_4_4_g8_Bounds) -> bool {
  if (bounds.tmin > bounds.tmax) {
    (*traversal).cell = vec3<i32>(-1);
    (*traversal).pending_step = voxc_r4_4_4_g8_NO_PENDING_STEP;
    return false;
  }
  voxc_r4_4_4_g8_end_after(ray, traversal, bounds.tmax);
  return true;
}

// Goes on with a traversal to the first voxel that the ray enters within the bounds. A traversal of which that cannot
// be told stays where it is, in that voxel; one that has come beyond the bounds ends.
fn voxc_r4_4_4_g8_traverse_within(volume: u32, ray: voxc_r4_4_4_g8_Ray, traversal: ptr<function,
    voxc_r4_4_4_g8_Traversal>, root: u32, bounds: voxc_r4_4_4_g8_Bounds) -> bool {
  var found: bool = false;
  var place: i32 = -1;
  while (place < 0) {
    found = (voxc_r4_4_4_g8_is_in_volume((*traversal).cell) || ((*traversal).pending_step >= 0))
        && voxc_r4_4_4_g8_continue_traversal(volume, ray, traversal, root);
    if (found) {
      place = voxc_r4_4_4_g8_place_of_entry(ray, *traversal, bounds);
    } else {
      place = 0;
    }
    if (place < 0) {
      voxc_r4_4_4_g8_step_over_voxel(ray, traversal);
    }
  }
  if (found && place == 1) {
    (*traversal).cell = vec3<i32>(-1);
  }
  return found && place == 0;
}

// What rays find, as it is told outside.

// A voxel on a ray. A miss is -1, -1, -1, 0, 0, -1, 0.
struct voxc_r4_4_4_g8_Hit {
  voxel: vec3<i32>,
  t: f32,      // When the ray enters it, rounded to nearest; 0 where the ray begins in it.
  colour: u32, // Its word: R in the lowest byte, then G, B and A; or a label.
  // Of the face by which the ray enters, 0, 1, 2 for x, y, z; the first of several. -1 where the ray begins inside.
  axis: i32,
  side: i32,   // -1 where that is the voxel's low face, 1 where it is the high one; 0 where there is none.
}

fn voxc_r4_4_4_g8_miss() -> voxc_r4_4_4_g8_Hit { return voxc_r4_4_4_g8_Hit(vec3<i32>(-1), 0.0f, 0u, -1, 0); }

fn voxc_r4_4_4_g8_hit_of(volume: u32, ray: voxc_r4_4_4_g8_Ray,
    traversal: voxc_r4_4_4_g8_Traversal) -> voxc_r4_4_4_g8_Hit {
  var sure: bool;
  let arrival = voxc_r4_4_4_g8_arrival_at(ray, traversal, true, &sure);
  let inside = arrival.face == voxc_r4_4_4_g8_BEGINS_INSIDE;
  let axis = select(i32(arrival.face >> 1u), -1, inside);
  let side = select(select(-1, 1, (arrival.face & 1u) != 0u), 0, inside);
  return voxc_r4_4_4_g8_Hit(traversal.cell, bitcast<f32>(arrival.t), voxc_r4_4_4_g8_colour_of(volume, traversal), axis,
      side);
}

// The normal of the face by which the ray enters, out of the voxel; 0 where there is none.
fn voxc_r4_4_4_g8_normal(hit: voxc_r4_4_4_g8_Hit) -> vec3<f32> {
  return vec3<f32>(vec3<i32>(vec3<i32>(hit.axis) == vec3<i32>(0, 1, 2)) * hit.side);
}

// Where the ray of a hit enters the voxel, just outside of it, and within its face: rays that go on from there begin in
// the cell before that face, and need no tmin to leave the voxel. In a voxel in which the ray begins, that is where it
// begins.
fn voxc_r4_4_4_g8_outside(origin: vec3<f32>, direction: vec3<f32>, hit: voxc_r4_4_4_g8_Hit) -> vec3<f32> {
  if (hit.axis < 0) {
    return origin;
  }
  let low = vec3<f32>(hit.voxel);
  let high = low + 1.0f;
  let within = clamp(origin + hit.t * direction, low, high - high / 8388608.0f);
  let beyond = select(low - max(low, vec3<f32>(1.0f)) / 8388608.0f, high, hit.side > 0);
  return select(within, beyond, vec3<i32>(hit.axis) == vec3<i32>(0, 1, 2));
}

// What is called from outside.

// Goes from the ray's begin, or from behind the traversal's voxel where it has one, to the next voxel within [tmin,
// tmax].
fn voxc_r4_4_4_g8_seek(volume: u32, origin: vec3<u32>, direction: vec3<u32>, tmin: f32, tmax: f32, ray: ptr<function,
    voxc_r4_4_4_g8_Ray>, traversal: ptr<function, voxc_r4_4_4_g8_Traversal>) -> bool {
  let goes_past = voxc_r4_4_4_g8_is_in_volume((*traversal).cell);
  let bounds = voxc_r4_4_4_g8_bounds_between(bitcast<u32>(tmin), bitcast<u32>(tmax));
  let root = voxc_r4_4_4_g8_load_word(volume, 0u); // Leads to level 1, unless the volume is empty.
  var found: bool = voxc_r4_4_4_g8_begin_traversal(origin, direction, root, ray,
      traversal) && voxc_r4_4_4_g8_bound_traversal(*ray, traversal, bounds);
  if (found) {
    if (goes_past) {
      voxc_r4_4_4_g8_step_over_voxel(*ray, traversal);
    } else {
      voxc_r4_4_4_g8_skip_to(*ray, traversal, bounds.tmin);
    }
    found = voxc_r4_4_4_g8_traverse_within(volume, *ray, traversal, root, bounds);
  }
  return voxc_r4_4_4_g8_end_traversal(origin, direction, traversal, found);
}

// The first voxel that the ray enters at a t in [tmin, tmax], in exact arithmetic; a NaN is in no interval. The voxel
// in which the ray begins is entered at t = 0. So with a tmin above 0 a ray that starts in a solid does not see the
// voxels that it has entered by then, but the next, which it enters through a face that is hidden.
fn voxc_r4_4_4_g8_closest(volume: u32, origin: vec3<f32>, direction: vec3<f32>, tmin: f32, tmax: f32, hit: ptr<function,
    voxc_r4_4_4_g8_Hit>) -> bool {
  var ray: voxc_r4_4_4_g8_Ray;
  var traversal: voxc_r4_4_4_g8_Traversal = voxc_r4_4_4_g8_traversal_at(vec3<i32>(-1));
  let found = voxc_r4_4_4_g8_seek(volume, bitcast<vec3<u32>>(origin), bitcast<vec3<u32>>(direction), tmin, tmax, &ray,
      &traversal);
  *hit = voxc_r4_4_4_g8_miss();
  if (found) {
    *hit = voxc_r4_4_4_g8_hit_of(volume, ray, traversal);
  }
  return found;
}

// From a hit of this very ray to the next voxel on it, if that is entered at tmax or before. None is left out or comes
// twice, also where several are entered at one moment.
fn voxc_r4_4_4_g8_next(volume: u32, origin: vec3<f32>, direction: vec3<f32>, tmax: f32, hit: ptr<function,
    voxc_r4_4_4_g8_Hit>) -> bool {
  var ray: voxc_r4_4_4_g8_Ray;
  var traversal: voxc_r4_4_4_g8_Traversal = voxc_r4_4_4_g8_traversal_at((*hit).voxel);
  let found = voxc_r4_4_4_g8_is_in_volume((*hit).voxel) && voxc_r4_4_4_g8_seek(volume, bitcast<vec3<u32>>(origin),
      bitcast<vec3<u32>>(direction), 0.0f, tmax, &ray, &traversal);
  *hit = voxc_r4_4_4_g8_miss();
  if (found) {
    *hit = voxc_r4_4_4_g8_hit_of(volume, ray, traversal);
  }
  return found;
}

// Whether there is a voxel that the ray enters at a t in [tmin, tmax].
fn voxc_r4_4_4_g8_any(volume: u32, origin: vec3<f32>, direction: vec3<f32>, tmin: f32, tmax: f32) -> bool {
  var ray: voxc_r4_4_4_g8_Ray;
  var traversal: voxc_r4_4_4_g8_Traversal = voxc_r4_4_4_g8_traversal_at(vec3<i32>(-1));
  return voxc_r4_4_4_g8_seek(volume, bitcast<vec3<u32>>(origin), bitcast<vec3<u32>>(direction), tmin, tmax, &ray,
      &traversal);
}
