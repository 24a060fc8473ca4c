// How a ray comes to the voxel that it hits.
struct Arrival {
  uint t;    // The bits of a float32.
  uint face; // Twice the axis on which the ray enters, and 1 more where its coordinate falls.
};

const uint BEGINS_INSIDE = 6u; // No face.

// True if the ray comes into its cell on two axes at one moment.
bool enters_together(const Ray ray, ivec3 face, int a, int b) {
  return ray.moves[a] && ray.falls[a] == ray.falls[b] && compare_crossings(ray, a, face[a], b, face[b]) == 0;
}

// The first axis on which the ray comes into the traversal's cell as it enters that. Not sure if steps cannot decide. Without exactness, of several,
// at an edge, the one that the traversal has met.
int first_axis(const Ray ray, const Traversal traversal, out bool sure) {
  sure = true;
  int first = traversal.axis;
  if (!EXACT)
    return first;
  ivec3 face = traversal.cell + ivec3(ray.falls);
  real3 t = times_of(ray, real3(face));
  for (int axis = 0; axis < 2; axis++) {
    real apart = abs(t[axis] - t[traversal.axis]);
    real bound = min(abs(t[axis]), abs(t[traversal.axis])) * ROUNDINGS + ray.t_error;
    if (axis < first && ray.moves[axis] && ray.falls[axis] == ray.falls[traversal.axis] && !(apart > bound))
      sure = false;
  }
  if (EXACT_FALLBACK && !sure) {
    sure = true;
    for (int axis = 1; axis >= 0; axis--)
      first = axis < traversal.axis && enters_together(ray, face, axis, traversal.axis) ? axis : first;
  }
  return first;
}

// How the ray came to the traversal's cell. Not sure where float32 or doubles cannot decide.
Arrival arrival_at(const Ray ray, const Traversal traversal, bool hit, out bool sure) {
  Arrival arrival;
  arrival.t = 0u;
  arrival.face = BEGINS_INSIDE;
  sure = true;
  if (!hit || traversal.axis < 0)
    return arrival;
  if (T)
    arrival.t = crossing_time(ray, traversal.axis, entered_face(ray, traversal), sure);
  if (FACE) {
    bool sure_of_axis;
    int axis = first_axis(ray, traversal, sure_of_axis);
    arrival.face = 2u * uint(axis) + uint(ray.falls[axis]);
    sure = sure && sure_of_axis;
  }
  return arrival;
}
