// The face through which the ray entered its cell.
int entered_face(const Ray ray, const Walk walk) { return walk.cell[walk.axis] + (ray.falls[walk.axis] ? 1 : 0); }
