// A step that float32 cannot tell, by doubles from the ray as given. What they get wrong: two roundings of 2^-53 of a t, three
// of a coordinate, which is a sum of two numbers that may be larger than it.
const double FEW_ROUNDINGS = double(1.0f / 1125899906842624.0f); // 2^-50.
const double LATER_THAN_ANY = double(NEVER) * double(NEVER) * double(NEVER); // A direction as given may be small.

// When coordinate a passes a face; later than any other where it never changes.
double time_by_doubles(const Ray ray, int a, int face) {
  return ray.moves[a] ? (double(face) - exactly(ray.given_origin[a])) / exactly(ray.given_direction[a]) : LATER_THAN_ANY;
}

// A range of the coordinate that changes from `origin` with `direction`, at a t: the least, and how much more it may be.
double least_by_doubles(double origin, double direction, double t, out double doubt) {
  double way = t * direction;
  double least = (abs(origin) + abs(way)) * FEW_ROUNDINGS;
  doubt = direction == 0.0 ? 0.0 : least + least;
  return direction == 0.0 ? origin : origin + way - least;
}

// The cell of a cube of `side` voxels from `corner` on, in which a coordinate lies that is at least so much. A coordinate just
// below the cube, or in its last half cell, belongs to its first or last cell.
int cell_by_doubles(int corner, int side, double least, double doubt, inout bool sure) {
  double from = double(corner);
  double place = clamp(least, from, from + (double(side) - 0.5));
  double whole = floor(place);
  sure = sure && (side == 1 || place - whole < 1.0 - doubt);
  return int(whole);
}

// Steps over the gap around the walk's cell. False, and no step, if doubles cannot tell either.
bool step_by_doubles(const Ray ray, inout Walk walk, const Gap gap) {
  int side = gap.count << gap.log2_side;
  ivec3 corner = corner_of(ray, walk.cell, gap);
  ivec3 face = corner + (ray.ahead & side);
  dvec3 t = dvec3(time_by_doubles(ray, 0, face.x), time_by_doubles(ray, 1, face.y), time_by_doubles(ray, 2, face.z));
  double first = min(min(t.x, t.y), t.z);
  bvec3 crossed = lessThanEqual(t, dvec3(first + abs(first) * FEW_ROUNDINGS));
  ivec3 count = ivec3(crossed);
  bool sure = ray.plain && count.x + count.y + count.z == 1;
  corner += mix(ivec3(0), ray.heading, crossed) * side;
  dvec3 origin = dvec3(exactly(ray.given_origin.x), exactly(ray.given_origin.y), exactly(ray.given_origin.z));
  dvec3 direction = dvec3(exactly(ray.given_direction.x), exactly(ray.given_direction.y), exactly(ray.given_direction.z));
  dvec3 doubt;
  dvec3 least = dvec3(least_by_doubles(origin.x, direction.x, first, doubt.x),
                      least_by_doubles(origin.y, direction.y, first, doubt.y),
                      least_by_doubles(origin.z, direction.z, first, doubt.z));
  ivec3 cell = ivec3(cell_by_doubles(corner.x, side, least.x, doubt.x, sure),
                     cell_by_doubles(corner.y, side, least.y, doubt.y, sure),
                     cell_by_doubles(corner.z, side, least.z, doubt.z, sure));
  walk.cell = sure ? cell : walk.cell;
%if axis
  walk.axis = sure ? (crossed.z ? 2 : crossed.y ? 1 : 0) : walk.axis;
%end
  return sure;
}
