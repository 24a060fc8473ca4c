// Where a walk begins: in the cell of the ray's origin, or in the first cell of the volume that the ray comes to.

const float CLOSE = 1.0f / 2048.0f; // In voxels.
const uint TINY_BITS = 0x30800000u; // Of 2^-30.

// Bounds what float32 gets wrong in a walk through the volume, where the origin itself is wrong by `of_origin`, and a t
// by `slack`. A coordinate that never changes stays in its cell, and passes no face.
void bound_errors(inout Ray ray, ivec3 cell, vec3 of_origin, float slack) {
  ${real3} reach = max(abs(ray.origin), abs(${real3}(VOLUME_SIZE) - ray.origin));
  ${real3} error = reach * ROUNDINGS + ${real3}(of_origin) + slack * abs(ray.direction);
  ray.slack = slack;
  ray.lowest = mix(${real3}(cell) + 0.25f, ray.origin - error, ray.moves);
  ray.doubt = mix(${real3}(0.0f), 2.0f * error, ray.moves);
  ray.certain = 1.0f - max(max(ray.doubt.x, ray.doubt.y), ray.doubt.z);
  ray.origin = mix(${real3}(-NEVER), ray.origin, ray.moves);
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
  ray.late = ${real3}(0.0f);
  bound_errors(ray, cell, error, 2.0f * max(max(slack.x, slack.y), slack.z));
}

// Puts a walk into the cell that the ray comes to where it passes a face, in exact arithmetic. `cell` tells the coordinates that
// never change.
Walk behind_face(const Ray ray, Walk walk, ivec3 cell, int axis, int face) {
  Crossing crossing;
  crossing.t = (float(face) - ray.origin[axis]) * ray.inverse[axis] - ray.late[axis];
  crossing.axis = axis;
  crossing.face = face;
  crossing.rising = !ray.falls[axis];
  Range range = Range(mix(cell, ivec3(-1), ray.moves), mix(cell, VOLUME_SIZE, ray.moves));
  range.least[axis] = range.most[axis] = face - (ray.falls[axis] ? 1 : 0);
%if bounded
  range = approximate_cell(ray, crossing, range);
  if (!SETTLES && range.least != range.most)
    return walk; // It stays, which is not wrong: only later cells are skipped to.
  walk.cell = range.least;
  if (SETTLES)
    walk.cell = settle(ray, crossing, range);
%else
  walk.cell = settle(ray, crossing, approximate_cell(ray, crossing, range));
%end
%if axis
  walk.axis = axis;
%end
  return walk;
}

// Finds the cell in which the ray enters the volume, in exact arithmetic: through the last of the faces that it must pass.
OUT_OF_LINE Walk entered_exactly(inout Ray ray, Walk walk, ivec3 cell, bvec3 enters, ivec3 face, bool starts_far) {
  int axis = last_entered(ray, enters, face);
  if (starts_far)
    start_at(ray, cell, axis, face[axis]);
  return behind_face(ray, walk, cell, axis, face[axis]);
}

// The same by ${real-name}. Not sure if that cannot tell which face is the last, or which cell is behind it.
Walk entered(const Ray ray, Walk walk, bvec3 enters, ivec3 face, out bool sure) {
  ${real3} t = mix(${real3}(-NEVER), times_of(ray, face), enters);
  ${real} latest = max(max(t.x, t.y), t.z);
  bvec3 may_be_last = greaterThanEqual(t, ${real3}(latest - (latest * ROUNDINGS + ray.slack)));
  ivec3 count = ivec3(may_be_last);
  ${real3} point = ray.lowest + latest * ray.direction;
  ${real3} whole = floor(point);
  bvec3 certain = lessThan(point - whole, 1.0f - ray.doubt);
  sure = count.x + count.y + count.z == 1 && all(greaterThan(ivec3(certain) + count, ivec3(0)));
  ivec3 behind = face - ivec3(ray.falls);
  walk.cell = mix(ivec3(clamp(whole, -1.0f, 4194304.0f)), behind, may_be_last);
%if axis
  walk.axis = may_be_last.x ? 0 : may_be_last.y ? 1 : 2;
%end
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
  ivec3 face = mix(ivec3(0), size, ray.falls);
  bvec3 axes = greaterThan(enters, ivec3(0));
  Start near = come_near(ray, axes, face);
  bool starts_far = near.is_far;
  bound_errors(ray, cell, vec3(near.wrong), any(starts_tiny(ray)) ? NEVER : near.slack);
  walk.cell = cell;
  if (enters != ivec3(0)) {
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
