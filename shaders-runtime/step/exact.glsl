// Steps that are exact for every ray: float32 where its error bound decides, integers elsewhere.

// Of the axes that may pass their face first, those that do.
ivec3 settle_first(const Ray ray, ivec3 face, bvec3 near) {
  int first = near.x ? 0 : 1;
  ivec3 crossed = ivec3(0);
  crossed[first] = 1;
  for (int axis = first + 1; axis < 3; axis++) {
    int order = near[axis] ? compare_crossings(ray, axis, face[axis], first, face[first]) : 1;
    if (order < 0) {
      crossed = ivec3(0);
      first = axis;
    }
    if (order <= 0)
      crossed[axis] = 1;
  }
  return crossed;
}

// The axes whose coordinates pass their face first, about at t: 1, others 0.
ivec3 first_crossed(const Ray ray, ivec3 face, vec3 t) {
  vec3 latest = t + ray.slack;
  float limit = min(min(latest.x, latest.y), latest.z);
  bvec3 near = lessThanEqual(t - ray.slack, vec3(limit));
  ivec3 crossed = ivec3(near);
  if (crossed.x + crossed.y + crossed.z > 1)
    crossed = settle_first(ray, face, near);
  return crossed;
}

// The cell, within [least, most], that the ray is in once a crossing has happened.
ivec3 cell_after(const Ray ray, const Crossing crossing, ivec3 least, ivec3 most) {
  return exact_cell(ray, crossing, least, most);
}
