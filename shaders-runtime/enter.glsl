// Where a traversal begins: in the cell of the ray's origin, or in the first cell of the volume that the ray comes to.

const float CLOSE = 1.0f / 2048.0f; // In voxels.

// Bounds what float32 gets wrong in a traversal through the volume, where the origin itself is wrong by `of_origin`, and a t
// by `t_error`. A coordinate that never changes stays in its cell.
void bound_errors(inout Ray ray, real3 cell, float of_origin, float t_error) {
  real3 half_size = 0.5f * real3(VOLUME_SIZE);
  real3 reach = abs(ray.origin - half_size) + half_size; // To the farther of the volume's two faces.
  real error = greatest_of(reach) * ROUNDINGS + real(of_origin);
  if (COMES_NEAR || EXACT_FALLBACK)
    error = min(error + 2.0f * t_error, real(NEVER));
  ray.t_error = t_error;
  ray.origin_low = mix(cell + 0.25f, ray.origin - error, ray.moves);
  ray.coordinate_error = 2.0f * error;
  ray.cell_margin = 1.0f - ray.coordinate_error;
}

// True where the ray moves from a coordinate so close to 0 that it may pass that face before float32 says so, as scaled directions
// have no component below 2^-60.
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
      error = max(error, CLOSE + CLOSE * abs(float(ray.origin[other])) / 256.0f); // More than a few roundings.
    }
  }
  vec3 steep = mix(vec3(0.0f), abs(vec3(ray.inverse)), ray.moves);
  ray.late = real3(0.0f);
  bound_errors(ray, real3(cell), error, 2.0f * error * max(max(steep.x, steep.y), steep.z));
}

// Puts a traversal into the cell that the ray comes to where it passes a face, in exact arithmetic. `cell` tells the coordinates that
// never change.
Traversal behind_face(const Ray ray, Traversal traversal, ivec3 cell, int axis, int face) {
  Crossing crossing;
  crossing.t = (float(face) - ray.origin[axis]) * ray.inverse[axis] - ray.late[axis];
  crossing.axis = axis;
  crossing.face = face;
  crossing.rising = !ray.falls[axis];
  Range range = Range(mix(cell, ivec3(-1), ray.moves), mix(cell, VOLUME_SIZE, ray.moves));
  range.most[axis] = face - (ray.falls[axis] ? 1 : 0);
  range.least[axis] = range.most[axis];
  if (BOUNDED) {
    range = approximate_cell(ray, crossing, range);
    ivec3 behind = range.least;
    bool sure = range.least == range.most;
    if (REFINES && !sure)
      behind = cell_behind(ray, axis, face, sure);
    if (EXACT_FALLBACK)
      behind = resolve_cell(ray, crossing, range);
    else if (!sure)
      return traversal; // It stays, which is not wrong: only later cells are skipped to.
    traversal.cell = behind;
  } else {
    traversal.cell = resolve_cell(ray, crossing, approximate_cell(ray, crossing, range));
  }
  traversal.axis = axis;
  return traversal;
}

// Finds the cell in which the ray enters the volume, in exact arithmetic: that of its origin, or through the last of the faces that it
// must pass. A cell outside if there is none.
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

// The same by float32 or doubles, of an ordinary ray: it passes the last of these faces, or is past all of them. Not sure if that cannot decide
// which face is the last, or which cell is behind it.
Traversal entered(const Ray ray, Traversal traversal, real3 face, inout bool sure) {
  const float LATEST = 281474976710656.0f; // 2^48: a ray of a voxel a moment is past the volume by then, whatever enters last.
  real3 t = mix(real3(-1.0f), times_of(ray, face), ray.moves); // A coordinate that never changes stays outside.
  bool is_as_given = ray.t_error == 0.0f;                      // Else it has come near, and does not begin here.
  // From a last face, which is not in the volume, a ray enters at 0; its t is a 0 with a sign.
  real3 last_face = mix(real3(NEVER), face, ray.falls);
  bvec3 on_face = equal(ray.origin, is_as_given ? last_face : real3(NEVER));
  t = mix(t, real3(0.0f), on_face);
  real latest = min(greatest_of(t), real(LATEST));
  real before = second_least_of(t);
  bvec3 passed = equal(t, real3(latest));
  bool begins_here = !(latest > 0.0f) && is_as_given && !any(on_face);
  real3 point = mix(ray.origin_low + latest * ray.direction, face + ray.beyond, passed);
  point = begins_here ? ray.origin : point;
  real3 whole = floor(point);
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
  ivec3 below = ivec3(lessThan(ray.origin, real3(0.0f)));
  ivec3 above = ivec3(greaterThanEqual(ray.origin, real3(VOLUME_SIZE)));
  return mix(above, below, ray.falls) != ivec3(0);
}

// Puts the traversal into the first cell of the volume on the ray; false if there is none, or if the ray is left.
bool enter_volume(inout Ray ray, inout Traversal traversal, bool ordinary) {
  if (COMES_NEAR && ordinary && leaves_volume(ray))
    return false;
  real3 face = mix(real3(0.0f), real3(VOLUME_SIZE), ray.falls);
  real3 cell = floor(ray.origin);
  Start near = come_near(ray, face);
  if (EXACT_FALLBACK && !ordinary && any(starts_tiny(ray)))
    near.t_error = NEVER;
  bound_errors(ray, cell, near.wrong, near.t_error);
  bool has_begun = is_in_volume(traversal.cell) || traversal.pending_step >= 0;
  if (EXACT_FALLBACK && has_begun && !near.is_far)
    return true; // Where it has entered need not be found again.
  bool sure = ordinary && !near.is_far;
  Traversal start = entered(ray, traversal, face, sure);
  if ((REFINES ? !EXACT_FALLBACK : NEAREST && EXACT_FALLBACK) && !sure && ordinary && !near.is_far)
    start = entered_compensated(ray, traversal, sure);
  if (IEEE && !REFINES && EXACT_FALLBACK && !sure && ordinary && !near.is_far)
    start = entered_by_doubles(ray, traversal, sure);
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
