// A step that float32 cannot decide, by doubles from the ray as given: where the ray passes faces one after the other, and where it passes
// several at one t, as rays of whole numbers do at nearly each step. What doubles get wrong: two roundings of 2^-53 of a t, three of a
// coordinate, which is a sum of two numbers that may be larger than it. What is closer than that meets exactly, or is undecided.
const double FEW_ROUNDINGS = double(1.0f / 1125899906842624.0f);             // 2^-50.
const double LATER_THAN_ANY = double(NEVER) * double(NEVER) * double(NEVER); // A direction as given may be small.

dvec3 exactly(uvec3 bits) { return dvec3(exactly(bits.x), exactly(bits.y), exactly(bits.z)); }

// When a ray passes a face, or several.
struct Passage {
  double t;
  int axis;     // Of one of them,
  Way way;      // with the way to it,
  double speed; // and the direction there.
  bool rises;   // Rising coordinates pass faces, which change cell before those that fall.
};

// When a coordinate passes a face; later than any other where it never changes.
double time_by_doubles(bool moves, const Way way, double speed) { return moves ? way.distance / speed : LATER_THAN_ANY; }

// The passage of one of three faces, to which these are the ways.
Passage passage_of(int axis, double t, const Way x, const Way y, const Way z, dvec3 speed) {
  Passage passage;
  passage.t = t;
  passage.axis = axis;
  passage.way = axis == 0 ? x : axis == 1 ? y : z;
  passage.speed = axis == 0 ? speed.x : axis == 1 ? speed.y : speed.z;
  passage.rises = passage.speed > double(0.0f);
  return passage;
}

// Whether a coordinate, that of `axis`, passes its face when the passage is. Not sure if only integers can decide.
bool is_passed(const Passage passage, int axis, double t, const Way way, double speed, inout bool sure) {
  bool is_close = abs(t - passage.t) <= abs(passage.t) * FEW_ROUNDINGS;
  bool meets = axis == passage.axis || meet(passage.way, passage.speed, way, speed);
  sure = sure && (meets || !is_close);
  return meets && is_close;
}

// The cell of a coordinate when the passage is, of `side` from `corner` on, if it is not among those that change then.
int cell_by_doubles(const Passage passage, double origin, double speed, int corner, int side, inout bool sure) {
  double way = passage.t * speed;
  double place = origin + way;
  double whole = floor(place + double(0.5f));
  bool is_close = speed != double(0.0f) && abs(place - whole) <= (abs(origin) + abs(way)) * FEW_ROUNDINGS;
  bool meets = meet(passage.way, passage.speed, way_to(whole, origin), speed);
  sure = sure && (meets || !is_close || side == 1);
  bool is_below = is_close && speed < double(0.0f) && !passage.rises; // It falls through that face with the others.
  double cell = is_close ? whole - double(is_below) : floor(place);
  return int(clamp(cell, double(corner), double(corner + side - 1)));
}

// Steps over the empty span around the traversal's cell. False, and no step, if doubles cannot decide either.
bool step_by_doubles(const Ray ray, inout Traversal traversal, const EmptySpan span) {
  int side = span.count << span.log2_side;
  ivec3 corner = corner_of(ray, traversal.cell, span);
  ivec3 face = corner + (ray.ahead & side);
  dvec3 origin = exactly(ray.given_origin);
  dvec3 speed = exactly(ray.given_direction);
  Way x = way_to(double(face.x), origin.x);
  Way y = way_to(double(face.y), origin.y);
  Way z = way_to(double(face.z), origin.z);
  dvec3 t = dvec3(time_by_doubles(ray.moves.x, x, speed.x), time_by_doubles(ray.moves.y, y, speed.y),
                  time_by_doubles(ray.moves.z, z, speed.z));
  double earliest = min(min(t.x, t.y), t.z);
  Passage first = passage_of(t.x == earliest ? 0 : t.y == earliest ? 1 : 2, earliest, x, y, z, speed);
  bool sure = ray.plain;
  bvec3 passed = bvec3(is_passed(first, 0, t.x, x, speed.x, sure), is_passed(first, 1, t.y, y, speed.y, sure),
                       is_passed(first, 2, t.z, z, speed.z, sure));
  ivec3 rising = ray.ahead & ivec3(passed);
  first.rises = (rising.x | rising.y | rising.z) != 0;
  bvec3 changes = greaterThan(first.rises ? rising : ivec3(passed), ivec3(0));
  corner += mix(ivec3(0), ray.heading, changes) * side;
  ivec3 cell = ivec3(cell_by_doubles(first, origin.x, speed.x, corner.x, side, sure),
                     cell_by_doubles(first, origin.y, speed.y, corner.y, side, sure),
                     cell_by_doubles(first, origin.z, speed.z, corner.z, side, sure));
  cell = mix(cell, mix(corner, corner + (side - 1), ray.falls), changes);
  traversal.cell = sure ? cell : traversal.cell;
  traversal.axis = sure ? (changes.x ? 0 : changes.y ? 1 : 2) : traversal.axis;
  return sure;
}

// The cell that the ray is in once a passage has happened, of all of the volume and those beside it.
ivec3 cell_after(const Passage passage, dvec3 origin, dvec3 speed, inout bool sure) {
  ivec3 size = VOLUME_SIZE + 2;
  return ivec3(cell_by_doubles(passage, origin.x, speed.x, -1, size.x, sure),
               cell_by_doubles(passage, origin.y, speed.y, -1, size.y, sure),
               cell_by_doubles(passage, origin.z, speed.z, -1, size.z, sure));
}

// The same, where coordinate `axis` passes a face. Not sure if doubles cannot decide.
ivec3 cell_behind(const Ray ray, int axis, int face, out bool sure) {
  dvec3 origin = exactly(ray.given_origin);
  dvec3 speed = exactly(ray.given_direction);
  Way way = way_to(double(face), axis == 0 ? origin.x : axis == 1 ? origin.y : origin.z);
  Passage passage = passage_of(axis, double(0.0f), way, way, way, speed);
  passage.t = way.distance / passage.speed;
  sure = ray.plain;
  ivec3 cell = cell_after(passage, origin, speed, sure);
  int behind = passage.rises ? face : face - 1;
  return ivec3(axis == 0 ? behind : cell.x, axis == 1 ? behind : cell.y, axis == 2 ? behind : cell.z);
}

// Finds the cell in which an ordinary ray enters the volume: that of its origin, or through the last of the faces that it must pass. A cell
// outside if there is none. Not sure if doubles cannot decide either.
Traversal entered_by_doubles(const Ray ray, Traversal traversal, out bool sure) {
  dvec3 origin = exactly(ray.given_origin);
  dvec3 speed = exactly(ray.given_direction);
  bvec3 below = lessThan(origin, dvec3(0.0f));
  bvec3 above = greaterThanEqual(origin, dvec3(VOLUME_SIZE));
  ivec3 is_outside = ivec3(below) | ivec3(above);
  ivec3 enters = (ivec3(below) & ray.ahead) | (ivec3(above) & ~ray.ahead);
  enters = enters & ivec3(ray.moves);
  ivec3 face = mix(ivec3(0), VOLUME_SIZE, ray.falls);
  Way x = way_to(double(face.x), origin.x);
  Way y = way_to(double(face.y), origin.y);
  Way z = way_to(double(face.z), origin.z);
  dvec3 t = dvec3(enters.x != 0 ? x.distance / speed.x : double(-1.0f), enters.y != 0 ? y.distance / speed.y : double(-1.0f),
                  enters.z != 0 ? z.distance / speed.z : double(-1.0f));
  double latest = max(max(t.x, t.y), t.z);
  Passage last = passage_of(t.x == latest ? 0 : t.y == latest ? 1 : 2, latest, x, y, z, speed);
  bool begins_here = is_outside == ivec3(0);
  sure = true;
  bvec3 passed = bvec3(is_passed(last, 0, t.x, x, speed.x, sure), is_passed(last, 1, t.y, y, speed.y, sure),
                       is_passed(last, 2, t.z, z, speed.z, sure));
  ivec3 falling = ~ray.ahead & ivec3(passed);
  last.rises = (falling.x | falling.y | falling.z) == 0; // The last of them fall.
  ivec3 cell = cell_after(last, origin, speed, sure);
  cell = mix(cell, mix(ivec3(0), VOLUME_SIZE - 1, ray.falls), passed);
  bool misses = is_outside != enters;
  traversal.cell = begins_here ? ivec3(floor(origin)) : misses ? ivec3(-1) : cell;
  sure = sure || begins_here || misses;
  ivec3 entry = last.rises ? ivec3(passed) : falling;
  traversal.axis = begins_here ? -1 : entry.x != 0 ? 0 : entry.y != 0 ? 1 : 2;
  return traversal;
}
