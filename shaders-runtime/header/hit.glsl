// What rays find, as it is told outside.

// A voxel on a ray. A miss is -1, -1, -1, 0, 0, -1, 0.
struct voxc_format_Hit {
  ivec3 voxel;
  float t;     // When the ray enters it, rounded to nearest; 0 where the ray begins in it.
  uint colour; // Its word: R in the lowest byte, then G, B and A; or a label.
  int axis;    // Of the face by which the ray enters, 0, 1, 2 for x, y, z; the first of several. -1 where the ray begins inside.
  int side;    // -1 where that is the voxel's low face, 1 where it is the high one; 0 where there is none.
};

voxc_format_Hit miss() { return voxc_format_Hit(ivec3(-1), 0.0f, 0u, -1, 0); }

voxc_format_Hit hit_of(const Ray ray, const Traversal traversal) {
  bool sure;
  Arrival arrival = arrival_at(ray, traversal, true, sure);
  bool inside = arrival.face == BEGINS_INSIDE;
  int axis = inside ? -1 : int(arrival.face >> 1);
  int side = inside ? 0 : (arrival.face & 1u) != 0u ? 1 : -1;
  return voxc_format_Hit(traversal.cell, uintBitsToFloat(arrival.t), colour_of(traversal), axis, side);
}

// The normal of the face by which the ray enters, out of the voxel; 0 where there is none.
vec3 voxc_format_normal(const voxc_format_Hit hit) { return vec3(ivec3(equal(ivec3(hit.axis), ivec3(0, 1, 2))) * hit.side); }

// Where the ray of a hit enters the voxel, just outside of it, and within its face: rays that go on from there begin in the cell
// before that face, and need no tmin to leave the voxel. In a voxel in which the ray begins, that is where it begins.
vec3 voxc_format_outside(vec3 origin, vec3 direction, const voxc_format_Hit hit) {
  if (hit.axis < 0)
    return origin;
  vec3 low = vec3(hit.voxel);
  vec3 high = low + 1.0f;
  vec3 within = clamp(origin + hit.t * direction, low, high - high / 8388608.0f);
  vec3 beyond = hit.side > 0 ? high : low - max(low, 1.0f) / 8388608.0f;
  return mix(within, beyond, equal(ivec3(hit.axis), ivec3(0, 1, 2)));
}
