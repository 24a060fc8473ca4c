// A step that float32 cannot decide, by sums of two float32 from the ray as given (pairs.glsl): where the ray passes
// faces one after the other, and where it passes several at one t, as rays of whole numbers do at nearly each step.
//
// No number of a moderate ray but 0 is below 2^-40, so that each is a multiple of 2^-63, and each product of two a multiple of 2^-126: what
// float32 loses of a sum or a product is a float32. A t is wrong by less than 2^-44 of it: a quotient by the inverse is within 2^-23, what is left
// of the way then is rounded twice, and multiplied by the inverse again. A coordinate is wrong by less than 2^-43 of the two numbers that it
// is the sum of. What is closer than ERROR_BOUND meets exactly, or is undecided.
const float ERROR_BOUND = 1.0f / 4398046511104.0f; // 2^-42.

// How much later one moment is than another.
float delay(const Pair later, const Pair earlier) { return (later.high - earlier.high) + (later.low - earlier.low); }

// How a coordinate passes a face.
struct Pass {
  Pair t;
  Pair way;    // From the ray's origin to the face,
  float speed; // and the direction.
};

// What is left of a way when nearly all of it is gone at that speed for that time.
float left_of(float way, float t, float speed) {
  if (REFINES)
    return fma(-t, speed, way);
  precise float gone = t * speed;
  precise float left = (way - gone) - lost_of(gone, t, speed);
  return left;
}

// At moment `otherwise` if it does not.
Pass pass_of(bool passes, float otherwise, float face, float origin, float speed, float inverse) {
  Pair way = exact_sum(face, -origin);
  float t = way.high * inverse;
  float rest = (left_of(way.high, t, speed) + way.low) * inverse;
  return Pass(passes ? Pair(t, rest) : Pair(otherwise, 0.0f), way, speed);
}

// Whether two coordinates pass their faces at one t: the ways by each other's speed are equal in all bits. False says nothing.
bool meet(const Pass a, const Pass b) {
  precise float of_a = a.way.high * b.speed;
  precise float of_b = b.way.high * a.speed;
  bool is_same = of_a == of_b && lost_of(of_a, a.way.high, b.speed) == lost_of(of_b, b.way.high, a.speed);
  bool is_whole = a.way.low == 0.0f && b.way.low == 0.0f;
  return is_same && (is_whole || (a.way.low == b.way.low && a.speed == b.speed));
}

// Whether a coordinate passes its face when the first one does. Not sure if only integers can decide.
bool is_passed(const Pass first, const Pass other, inout bool sure) {
  bool is_close = abs(delay(other.t, first.t)) <= first.t.high * ERROR_BOUND;
  bool meets = meet(first, other);
  sure = sure && (meets || !is_close);
  return meets && is_close;
}

// The cell of a coordinate at the first passage, of `side` from `corner` on, if it is not among those that change then. Those that pass with it
// rise, or all of them fall.
int cell_at(const Pass first, bool rises, float origin, float speed, int corner, int side, inout bool sure) {
  precise float way = first.t.high * speed;
  float rest = first.t.low * speed + lost_of(way, first.t.high, speed);
  Pair sum = exact_sum(origin, way);
  Pair place = exact_sum(sum.high, sum.low + rest); // What is left of two large numbers may be less than their rest.
  float whole = floor(place.high + 0.5f);
  float above = (place.high - whole) + place.low;
  bool is_close = speed != 0.0f && abs(above) <= (abs(origin) + abs(way)) * ERROR_BOUND;
  bool meets = meet(first, Pass(first.t, exact_sum(whole, -origin), speed));
  sure = sure && (meets || !is_close || side == 1);
  bool is_below = is_close ? speed < 0.0f && !rises : above < 0.0f; // It falls through that face with the others.
  return int(clamp(whole - (is_below ? 1.0f : 0.0f), float(corner), float(corner + side - 1)));
}

// Steps over the empty span around the traversal's cell. False, and no step, if this cannot decide either.
bool step_compensated(const Ray ray, inout Traversal traversal, const EmptySpan span) {
  int side = span.count << span.log2_side;
  ivec3 corner = corner_of(ray, traversal.cell, span);
  vec3 face = vec3(corner + (ray.ahead & side));
  vec3 origin = uintBitsToFloat(ray.given_origin);
  vec3 speed = mix(vec3(0.0f), ray.direction, ray.moves);
  Pass x = pass_of(ray.moves.x, NEVER, face.x, origin.x, speed.x, ray.inverse.x);
  Pass y = pass_of(ray.moves.y, NEVER, face.y, origin.y, speed.y, ray.inverse.y);
  Pass z = pass_of(ray.moves.z, NEVER, face.z, origin.z, speed.z, ray.inverse.z);
  Pass first = x;
  if (delay(y.t, first.t) < 0.0f)
    first = y;
  if (delay(z.t, first.t) < 0.0f)
    first = z;
  bool sure = ray.is_moderate;
  bvec3 passed = bvec3(is_passed(first, x, sure), is_passed(first, y, sure), is_passed(first, z, sure));
  ivec3 rising = ray.ahead & ivec3(passed);
  bool rises = (rising.x | rising.y | rising.z) != 0;
  bvec3 changes = greaterThan(rises ? rising : ivec3(passed), ivec3(0));
  corner += mix(ivec3(0), ray.heading, changes) * side;
  ivec3 cell = ivec3(cell_at(first, rises, origin.x, speed.x, corner.x, side, sure),
                     cell_at(first, rises, origin.y, speed.y, corner.y, side, sure),
                     cell_at(first, rises, origin.z, speed.z, corner.z, side, sure));
  cell = mix(cell, mix(corner, corner + (side - 1), ray.falls), changes);
  traversal.cell = sure ? cell : traversal.cell;
  traversal.axis = sure ? (changes.x ? 0 : changes.y ? 1 : 2) : traversal.axis;
  return sure;
}

// The cell of the volume, or beside it, that the ray comes to at a passage.
ivec3 cell_after(const Pass first, bool rises, vec3 origin, vec3 speed, inout bool sure) {
  ivec3 size = VOLUME_SIZE + 2;
  return ivec3(cell_at(first, rises, origin.x, speed.x, -1, size.x, sure),
               cell_at(first, rises, origin.y, speed.y, -1, size.y, sure),
               cell_at(first, rises, origin.z, speed.z, -1, size.z, sure));
}

// The same where coordinate `axis` passes a face. Not sure if this cannot decide.
ivec3 cell_behind(const Ray ray, int axis, int face, out bool sure) {
  vec3 origin = uintBitsToFloat(ray.given_origin);
  vec3 speed = mix(vec3(0.0f), ray.direction, ray.moves);
  Pass pass = pass_of(true, NEVER, float(face), origin[axis], speed[axis], ray.inverse[axis]);
  bool rises = !ray.falls[axis];
  sure = ray.is_moderate;
  ivec3 cell = cell_after(pass, rises, origin, speed, sure);
  int behind = rises ? face : face - 1;
  return ivec3(axis == 0 ? behind : cell.x, axis == 1 ? behind : cell.y, axis == 2 ? behind : cell.z);
}

// Finds the cell in which an ordinary ray enters the volume: that of its origin, or through the last of the faces that it must pass. A cell
// outside if there is none. Not sure if this cannot decide either.
Traversal entered_compensated(const Ray ray, Traversal traversal, out bool sure) {
  const float BEFORE = -1.0f; // All t of faces that the ray comes to.
  vec3 origin = uintBitsToFloat(ray.given_origin);
  vec3 speed = mix(vec3(0.0f), ray.direction, ray.moves);
  bvec3 below = lessThan(origin, vec3(0.0f));
  bvec3 above = greaterThanEqual(origin, vec3(VOLUME_SIZE));
  ivec3 is_outside = ivec3(below) | ivec3(above);
  ivec3 enters = ((ivec3(below) & ray.ahead) | (ivec3(above) & ~ray.ahead)) & ivec3(ray.moves);
  vec3 face = mix(vec3(0.0f), vec3(VOLUME_SIZE), ray.falls);
  Pass x = pass_of(enters.x != 0, BEFORE, face.x, origin.x, speed.x, ray.inverse.x);
  Pass y = pass_of(enters.y != 0, BEFORE, face.y, origin.y, speed.y, ray.inverse.y);
  Pass z = pass_of(enters.z != 0, BEFORE, face.z, origin.z, speed.z, ray.inverse.z);
  Pass last = x;
  if (delay(y.t, last.t) > 0.0f)
    last = y;
  if (delay(z.t, last.t) > 0.0f)
    last = z;
  bool begins_here = is_outside == ivec3(0);
  bool misses = is_outside != enters;
  sure = ray.is_moderate;
  bvec3 passed = bvec3(is_passed(last, x, sure), is_passed(last, y, sure), is_passed(last, z, sure));
  ivec3 falling = ~ray.ahead & ivec3(passed);
  bool rises = (falling.x | falling.y | falling.z) == 0; // The last of them fall.
  ivec3 cell = cell_after(last, rises, origin, speed, sure);
  cell = mix(cell, mix(ivec3(0), VOLUME_SIZE - 1, ray.falls), passed);
  traversal.cell = begins_here ? ivec3(floor(origin)) : misses ? ivec3(-1) : cell;
  sure = sure || begins_here || misses;
  ivec3 entry = rises ? ivec3(passed) : falling;
  traversal.axis = begins_here ? -1 : entry.x != 0 ? 0 : entry.y != 0 ? 1 : 2;
  return traversal;
}
