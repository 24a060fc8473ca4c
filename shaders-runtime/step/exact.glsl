// Steps that are exact for every ray: by float32 or doubles where these can tell, by integers elsewhere.

// How the ray leaves cells through the first of the faces ahead. Not sure if its t cannot tell which that is.
Exit leave(const Ray ray, real3 face) {
  real3 t = times_of(ray, face);
  real first = least_of(t);
  real second = second_least_of(t); // Of negative ones, none that is sure.
  return Exit(first, equal(t, real3(first)), second > first + (first * ROUNDINGS + ray.slack));
}

// The cell that a ray comes to where it leaves others, of which `cell` is one, by one of the faces ahead. Not sure if its point cannot tell on
// which side of another face that is.
ivec3 cell_beyond(const Ray ray, ivec3 cell, real3 face, inout Exit leaving) {
  real3 point = mix(ray.lowest + leaving.t * ray.direction, face + ray.beyond, leaving.passed);
  real3 whole = floor(point);
  bool is_certain = greatest_of(point - whole) < ray.certain;
  leaving.sure = leaving.sure && is_certain;
  return ivec3(whole);
}

// Settles the step over the gap around the walk's cell: which faces the ray passes first, of
// those that float32 cannot tell apart, and then by bisection to which cell it comes. All questions are asked at one place,
// since devices of wide vectors run through it as often as any ray needs it.
// Where the device cuts it short, the walk stays where it is.
OUT_OF_LINE Walk settled(const Ray ray, Walk walk, const Gap gap) {
  int side = gap.count << gap.log2_side;
  ivec3 corner = corner_of(ray, walk.cell, gap);
  ivec3 face = corner + (ray.ahead & side);
  real3 t = times_of(ray, real3(face));
  real earliest = min(min(t.x, t.y), t.z);
  bvec3 may_be_first = lessThanEqual(t, real3(earliest + (earliest * ROUNDINGS + ray.slack)));
  ivec3 bits = ivec3(may_be_first) * ivec3(ray.moves);
  int axes = bits.x | bits.y << 1 | bits.z << 2;
  int first = findLSB(uint(axes));
  axes &= axes - 1;
  bvec3 crossed = bvec3(first == 0, first == 1, first == 2);
  Crossing crossing;
  Range range = Range(ivec3(0), ivec3(1));
  bool orders = true;
  int order = 0;
  while (!(CUT && order == CUT_SHORT) && range.least != range.most) {
    if (orders && axes == 0) {
      orders = false;
      crossing = crossing_of(ray, face, earliest, crossed);
      ivec3 target = corner + crossing.step * side;
      range = approximate_cell(ray, crossing, Range(target, target + (side - 1)));
    }
    if (orders || range.least != range.most) {
      int axis = orders ? findLSB(uint(axes)) : undecided_axis(range);
      int at = orders ? face[axis] : middle_of(range, axis);
      order = compare_crossings(ray, axis, at, first, face[first]);
      if (!orders) {
        narrow(ray, crossing, axis, at, order, range);
      } else {
        if (order <= 0) {
          bvec3 others = order < 0 ? bvec3(false) : crossed;
          crossed = bvec3(others.x || axis == 0, others.y || axis == 1, others.z || axis == 2);
          first = axis;
        }
        axes &= axes - 1;
      }
    }
  }
  if (!(CUT && order == CUT_SHORT) && range.least == range.most) {
    walk.cell = range.least;
    walk.axis = crossing.axis;
  }
  return walk;
}

const int FEW_SETTLINGS = 2;
int settlings = 0; // How many steps of the ray were settled outside of the loops. Not of Walk, which the first dispatch has too.

// Settles the step of a walk that was left open.
void settle_step(const Ray ray, inout Walk walk) {
  Gap gap = Gap(walk.open & 31, walk.open >> 5);
  walk.open = CLOSED;
  walk.cell = ~walk.cell;
  if (!(IEEE || NEAREST) || REFINES) {
    walk = settled(ray, walk, gap);
    return;
  }
  // A loop, through which no lane goes where these tell.
  if (NEAREST) {
    for (bool is_left = !step_compensated(ray, walk, gap); is_left; is_left = false)
      walk = settled(ray, walk, gap);
    return;
  }
  ++settlings;
  // A loop, as above.
  for (bool is_left = !step_by_doubles(ray, walk, gap); is_left; is_left = false)
    walk = settled(ray, walk, gap);
}
