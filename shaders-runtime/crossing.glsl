// The moments at which a ray changes cell, in exact order. Cells are half-open, so where several coordinates pass a face
// at one t, rising ones change cell first, falling ones just after.

// A change of cell.
struct Crossing {
  float t;     // Approximate.
  int axis;    // One that changes,
  int face;    // and the face that it passes.
  ivec3 step;  // The change, a cell at most on each axis.
  bool rising; // Only rising coordinates change: those that fall may still stand on a boundary.
};

// How far coordinate a is behind at_a when coordinate b passes at_b, with the sign of both speeds:
// (at_a - origin_a) * direction_b - (at_b - origin_b) * direction_a.
Sum crossing_difference(const Ray ray, int a, float at_a, int b, float at_b) {
  uint speed_a = ray.given_direction[a];
  uint speed_b = ray.given_direction[b];
  return sum_of_products(uvec4(floatBitsToUint(at_a), ray.given_origin[a] ^ SIGN_BIT,
                               floatBitsToUint(at_b) ^ SIGN_BIT, ray.given_origin[b]),
                         uvec4(speed_b, speed_b, speed_a, speed_a));
}

// Below 0 if coordinate a passes its face first, 0 if both pass theirs at the same t. Both move.
int compare_crossings(const Ray ray, int a, int face_a, int b, int face_b) {
  int order = sign_of(crossing_difference(ray, a, float(face_a), b, float(face_b)));
  return ray.falls[a] == ray.falls[b] ? order : -order;
}

// Narrows [low, high] down, on each axis, to the cell that the ray is in once a crossing has happened.
ivec3 settle(const Ray ray, const Crossing crossing, ivec3 low, ivec3 high) {
  int axis = low.x != high.x ? 0 : low.y != high.y ? 1 : 2;
  while (low[axis] != high[axis]) {
    int face = low[axis] + (high[axis] - low[axis] + 1) / 2;
    int order = compare_crossings(ray, axis, face, crossing.axis, crossing.face);
    bool falls = ray.falls[axis];
    bool passed = order < 0 || (order == 0 && !(falls && crossing.rising));
    if (passed != falls)
      low[axis] = face;
    else
      high[axis] = face - 1;
    axis = low.x != high.x ? 0 : low.y != high.y ? 1 : 2;
  }
  return low;
}

// The cell, within [least, most], that the ray is in once a crossing has happened: float32 where its error bound
// decides, exact arithmetic elsewhere.
ivec3 exact_cell(const Ray ray, const Crossing crossing, ivec3 least, ivec3 most) {
  vec3 point = ray.origin + crossing.t * ray.direction;
  vec3 error = ray.error + ray.slack[crossing.axis] * abs(ray.direction);
  ivec3 low = ivec3(clamp(floor(point - error), vec3(least), vec3(most)));
  ivec3 high = ivec3(clamp(floor(point + error), vec3(least), vec3(most)));
  if (low != high)
    low = settle(ray, crossing, low, high);
  return low;
}
