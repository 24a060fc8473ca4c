// The moments at which a ray changes cell, in exact order. Cells are half-open, so where several coordinates pass a face
// at one t, rising ones change cell first, falling ones just after.

// A change of cell.
struct Crossing {
  real t;      // Approximate.
  int axis;    // One that changes,
  int face;    // and the face that it passes.
  ivec3 step;  // The change, a cell at most on each axis.
  bool rising; // Only rising coordinates change: those that fall may still stand on a boundary.
};

// The change of cell where a ray leaves a cube through the faces ahead: `crossed` tells the axes whose coordinates pass
// them first, about at t.
Crossing crossing_of(const Ray ray, ivec3 face, real t, bvec3 crossed) {
  ivec3 changes = mix(ivec3(0), ray.heading, crossed);
  ivec3 risen = max(changes, ivec3(0));
  Crossing crossing;
  crossing.rising = risen != ivec3(0);
  crossing.step = crossing.rising ? risen : changes;
  crossing.axis = crossing.step.x != 0 ? 0 : crossing.step.y != 0 ? 1 : 2;
  crossing.t = t;
  crossing.face = face[crossing.axis];
  return crossing;
}

// Cells from `least` to `most`.
struct Range {
  ivec3 least;
  ivec3 most;
};

// How far coordinate a is behind at_a when coordinate b passes at_b, with the sign of both speeds:
// (at_a - origin_a) * direction_b - (at_b - origin_b) * direction_a.
Sum crossing_difference(const Ray ray, int a, float at_a, int b, float at_b) {
  uint speed_a = ray.given_direction[a];
  uint speed_b = ray.given_direction[b];
  return sum_of_products(
      uvec4(floatBitsToUint(at_a), ray.given_origin[a] ^ SIGN_BIT, floatBitsToUint(at_b) ^ SIGN_BIT, ray.given_origin[b]),
      uvec4(speed_b, speed_b, speed_a, speed_a));
}

const int CUT_SHORT = 2; // No order: the device did not let it be found.

// A float32 number that a device might not keep is 0 here, and is not looked at.
double exactly(uint bits) { return double(uintBitsToFloat(bits)); }

// -1 or 1 if coordinate a passes its face before coordinate b or after it; 0 if doubles cannot decide. Four roundings of 2^-53
// are the most that they get wrong of the two products together.
int compare_by_doubles(const Ray ray, int a, int face_a, int b, int face_b) {
  double of_a = (double(face_a) - exactly(ray.given_origin[a])) * exactly(ray.given_direction[b]);
  double of_b = (double(face_b) - exactly(ray.given_origin[b])) * exactly(ray.given_direction[a]);
  double difference = of_a - of_b;
  double bound = (abs(of_a) + abs(of_b)) * double(1.0f / 1125899906842624.0f); // 2^-50.
  int order = difference > bound ? 1 : difference < -bound ? -1 : 0;
  order = ray.plain ? order : 0;
  return ray.falls[a] == ray.falls[b] ? order : -order;
}

// The way from a coordinate to a face, which is exact if taking it away from the larger of the two leaves the other. Its first 24 bits
// and the other 29 times a float32 are exact, each. Without `precise`, compilers may take a - b + b for a.
struct Way {
  double distance;
  double high;
  double low;
  bool is_exact;
};

Way way_to(double face, double origin) {
  precise double distance = face - origin;
  precise double high = double(float(distance));
  precise double low = distance - high;
  precise double as_face = distance + origin;
  precise double as_origin = face - distance;
  return Way(distance, high, low, as_face == face && as_origin == origin);
}

// Whether coordinates that go two ways get there at one t: they have few bits, or are the same on both axes. False says nothing.
bool meet(const Way a, double speed_a, const Way b, double speed_b) {
  precise double high_a = a.high * speed_b;
  precise double high_b = b.high * speed_a;
  precise double low_a = a.low * speed_b;
  precise double low_b = b.low * speed_a;
  bool same = high_a == high_b && low_a == low_b;
  return a.is_exact && b.is_exact && same;
}

// Whether a and b pass their faces at one t, seen by doubles. False says nothing.
bool meet_by_doubles(const Ray ray, int a, int face_a, int b, int face_b) {
  Way way_a = way_to(double(face_a), exactly(ray.given_origin[a]));
  Way way_b = way_to(double(face_b), exactly(ray.given_origin[b]));
  return ray.plain && meet(way_a, exactly(ray.given_direction[a]), way_b, exactly(ray.given_direction[b]));
}

// -1 if coordinate a passes its face first, 0 if both pass theirs at the same t, else 1. Both move.
OUT_OF_LINE int compare_exactly(const Ray ray, int a, int face_a, int b, int face_b) {
  Sum difference = crossing_difference(ray, a, float(face_a), b, float(face_b));
  int order = sign_of(difference);
  if (CUT)
    order = difference.complete ? order : CUT_SHORT;
  return (CUT && order == CUT_SHORT) || ray.falls[a] == ray.falls[b] ? order : -order;
}

// The same, by doubles where they can decide.
int compare_crossings(const Ray ray, int a, int face_a, int b, int face_b) {
  if (!IEEE)
    return compare_exactly(ray, a, face_a, b, face_b);
  int order = compare_by_doubles(ray, a, face_a, b, face_b);
  if (order == 0 && meet_by_doubles(ray, a, face_a, b, face_b))
    return 0;
  return order != 0 ? order : compare_exactly(ray, a, face_a, b, face_b);
}

int undecided_axis(const Range range) { return range.least.x != range.most.x ? 0 : range.least.y != range.most.y ? 1 : 2; }

int middle_of(const Range range, int axis) { return range.least[axis] + (range.most[axis] - range.least[axis] + 1) / 2; }

// Takes away from a range what lies to one side of a face, where `order` compares it with the crossing.
void narrow(const Ray ray, const Crossing crossing, int axis, int face, int order, inout Range range) {
  bool falls = ray.falls[axis];
  bool passed = order < 0 || (order == 0 && !(falls && crossing.rising));
  if (passed != falls)
    range.least[axis] = face;
  else
    range.most[axis] = face - 1;
}

// Narrows a range down, on each axis, to the cell that the ray is in once a crossing has happened.
OUT_OF_LINE ivec3 resolve_cell(const Ray ray, const Crossing crossing, const Range candidates) {
  Range range = candidates;
  while (range.least != range.most) {
    int axis = undecided_axis(range);
    int face = middle_of(range, axis);
    narrow(ray, crossing, axis, face, compare_crossings(ray, axis, face, crossing.axis, crossing.face), range);
  }
  return range.least;
}

// What can be told, without integers, of the cell, within a range, that the ray is in once a crossing has happened.
Range approximate_cell(const Ray ray, const Crossing crossing, const Range range) {
  real3 point = ray.origin_low + crossing.t * ray.direction;
  real3 bound = mix(real3(0.0f), real3(ray.coordinate_error), ray.moves);
  real3 least = real3(range.least);
  real3 most = real3(range.most);
  return Range(ivec3(clamp(floor(point), least, most)), ivec3(clamp(floor(point + bound), least, most)));
}
