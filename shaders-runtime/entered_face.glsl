// The face through which the ray entered its cell.
int entered_face(const Ray ray, const Traversal traversal) {
  return traversal.cell[traversal.axis] + (ray.falls[traversal.axis] ? 1 : 0);
}
