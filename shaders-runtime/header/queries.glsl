// What is called from outside.

// Goes from the ray's begin, or from behind the traversal's voxel where it has one, to the next voxel within [tmin, tmax].
bool seek(uvec3 origin, uvec3 direction, float tmin, float tmax, out Ray ray, inout Traversal traversal) {
  bool goes_past = is_in_volume(traversal.cell);
  Bounds bounds = bounds_between(floatBitsToUint(tmin), floatBitsToUint(tmax));
  uint root = load_word(0u); // Leads to level 1, unless the volume is empty.
  bool found = begin_traversal(origin, direction, root, ray, traversal) && bound_traversal(ray, traversal, bounds);
  if (found) {
    if (goes_past)
      step_over_voxel(ray, traversal);
    else
      skip_to(ray, traversal, bounds.tmin);
    found = traverse_within(ray, traversal, root, bounds);
  }
  return end_traversal(origin, direction, traversal, found);
}

// The first voxel that the ray enters at a t in [tmin, tmax], in exact arithmetic; a NaN is in no interval. The voxel in which
// the ray begins is entered at t = 0. So with a tmin above 0 a ray that starts in a solid does not see the voxels that it has
// entered by then, but the next, which it enters through a face that is hidden.
bool voxc_format_closest(vec3 origin, vec3 direction, float tmin, float tmax, out voxc_format_Hit hit) {
  Ray ray;
  Traversal traversal = traversal_at(ivec3(-1));
  if (PAGED)
    lacks_page = false; // A ray that waits for a word has the cell in which it waits for its hit, with no colour.
  bool found = seek(floatBitsToUint(origin), floatBitsToUint(direction), tmin, tmax, ray, traversal);
  hit = miss();
  if (found || (PAGED && lacks_page && is_in_volume(traversal.cell)))
    hit = hit_of(ray, traversal);
  return found && (!PAGED || !lacks_page);
}

// From a hit of this very ray to the next voxel on it, if that is entered at tmax or before. None is left out or comes twice, also
// where several are entered at one moment.
bool voxc_format_next(vec3 origin, vec3 direction, float tmax, inout voxc_format_Hit hit) {
  Ray ray;
  Traversal traversal = traversal_at(hit.voxel);
  bool found = is_in_volume(hit.voxel) && seek(floatBitsToUint(origin), floatBitsToUint(direction), 0.0f, tmax, ray, traversal);
  hit = miss();
  if (found)
    hit = hit_of(ray, traversal);
  return found;
}

// Whether there is a voxel that the ray enters at a t in [tmin, tmax].
bool voxc_format_any(vec3 origin, vec3 direction, float tmin, float tmax) {
  Ray ray;
  Traversal traversal = traversal_at(ivec3(-1));
  return seek(floatBitsToUint(origin), floatBitsToUint(direction), tmin, tmax, ray, traversal);
}
