// What is called from outside.

// A voxel on a ray. A miss is -1, -1, -1, 0, 0, -1, 0.
struct ${prefix}Hit {
  ivec3 voxel;
  float t;     // When the ray enters it, rounded to nearest; 0 where the ray begins in it.
  uint colour; // Its word: ${what-colour-is}.
  int axis;    // Of the face by which the ray enters, 0, 1, 2 for x, y, z; the first of several. -1 where the ray begins inside.
  int side;    // -1 where that is the voxel's low face, 1 where it is the high one; 0 where there is none.
};

${prefix}Hit miss() { return ${prefix}Hit(ivec3(-1), 0.0f, 0u, -1, 0); }

${prefix}Hit hit_of(const Ray ray, const Walk walk) {
  bool sure;
  Arrival arrival = arrival_at(ray, walk, true, sure);
  bool inside = arrival.face == BEGINS_INSIDE;
  int axis = inside ? -1 : int(arrival.face >> 1);
  int side = inside ? 0 : (arrival.face & 1u) != 0u ? 1 : -1;
  return ${prefix}Hit(walk.cell, uintBitsToFloat(arrival.t), colour_of(walk), axis, side);
}

// Walks from the ray's begin, or from the walk's voxel where it has one, to the next voxel within [tmin, tmax].
bool seek(uvec3 origin, uvec3 direction, float tmin, float tmax, out Ray ray, inout Walk walk) {
  bool goes_past = is_in_volume(walk.cell);
  uint least = moment_of(tmin);
  uint most = moment_of(tmax);
  uint root = load_word(0u); // Leads to level 1, unless the volume is empty.
  bool found = begin_walk(origin, direction, root, ray, walk) && is_interval(least, tmax);
  if (found) {
    end_after(ray, walk, most);
    if (least != 0u)
      skip_to(ray, walk, least);
    found = goes_past ? walk_past(ray, walk, root) : is_in_volume(walk.cell) && walk_on(ray, walk, root);
    found = walk_within(ray, walk, root, found, least, most);
  }
  return end_walk(origin, direction, walk, found);
}

// The first voxel that the ray enters at a t in [tmin, tmax], in exact arithmetic; a NaN is in no interval. The voxel in which
// the ray begins is entered at t = 0. So with a tmin above 0 a ray that starts in a solid does not see the voxels that it has
// entered by then, but the next, which it enters through a face that is hidden.
bool ${prefix}closest(vec3 origin, vec3 direction, float tmin, float tmax, out ${prefix}Hit hit) {
  Ray ray;
  Walk walk = walk_at(ivec3(-1));
  bool found = seek(floatBitsToUint(origin), floatBitsToUint(direction), tmin, tmax, ray, walk);
  hit = miss();
  if (found)
    hit = hit_of(ray, walk);
  return found;
}

// From a hit of this very ray to the next voxel on it, if that is entered at tmax or before. None is left out or comes twice, also
// where several are entered at one moment.
bool ${prefix}next(vec3 origin, vec3 direction, float tmax, inout ${prefix}Hit hit) {
  Ray ray;
  Walk walk = walk_at(hit.voxel);
  bool found = is_in_volume(hit.voxel) && seek(floatBitsToUint(origin), floatBitsToUint(direction), 0.0f, tmax, ray, walk);
  hit = miss();
  if (found)
    hit = hit_of(ray, walk);
  return found;
}

// Whether there is a voxel that the ray enters at a t in [tmin, tmax].
bool ${prefix}any(vec3 origin, vec3 direction, float tmin, float tmax) {
  Ray ray;
  Walk walk = walk_at(ivec3(-1));
  return seek(floatBitsToUint(origin), floatBitsToUint(direction), tmin, tmax, ray, walk);
}

// The normal of the face by which the ray enters, out of the voxel; 0 where there is none.
vec3 ${prefix}normal(const ${prefix}Hit hit) {
  return vec3(ivec3(equal(ivec3(hit.axis), ivec3(0, 1, 2))) * hit.side);
}

// Where the ray of a hit enters the voxel, just outside of it, and within its face: rays that go on from there begin in the cell
// before that face, and need no tmin to leave the voxel. In a voxel in which the ray begins, that is where it begins.
vec3 ${prefix}outside(vec3 origin, vec3 direction, const ${prefix}Hit hit) {
  if (hit.axis < 0)
    return origin;
  vec3 low = vec3(hit.voxel);
  vec3 high = low + 1.0f;
  vec3 within = clamp(origin + hit.t * direction, low, high - high / 8388608.0f);
  vec3 beyond = hit.side > 0 ? high : low - max(low, 1.0f) / 8388608.0f;
  return mix(within, beyond, equal(ivec3(hit.axis), ivec3(0, 1, 2)));
}
