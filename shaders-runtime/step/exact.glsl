// Steps that are exact for every ray: by float32 or doubles where these can decide, by integers elsewhere.

// How the ray leaves cells through the first of the faces ahead. Not sure if its t cannot decide which that is.
Exit leave(const Ray ray, real3 face) {
  real3 t = times_of(ray, face);
  real first = least_of(t);
  real second = second_least_of(t); // Of negative ones, none that is sure.
  return Exit(first, equal(t, real3(first)), second > first + (first * ROUNDINGS + ray.t_error));
}

// The cell that a ray comes to where it leaves others, of which `cell` is one, by one of the faces ahead. Not sure if its point cannot decide on
// which side of another face that is.
ivec3 cell_beyond(const Ray ray, ivec3 cell, real3 face, inout Exit leaving) {
  real3 point = mix(ray.origin_low + leaving.t * ray.direction, face + ray.beyond, leaving.passed);
  real3 whole = floor(point);
  bool is_certain = greatest_of(point - whole) < ray.cell_margin;
  leaving.sure = leaving.sure && is_certain;
  return ivec3(whole);
}

// Resolves the step over the empty span around the traversal's cell: which faces the ray passes first, of
// those that float32 cannot decide apart, and then by bisection to which cell it comes. All questions are asked at one place,
// since devices of wide vectors run through it as often as any ray needs it.
// Where the device cuts it short, the traversal stays where it is.
OUT_OF_LINE Traversal exact_step(const Ray ray, Traversal traversal, const EmptySpan span) {
  int side = span.count << span.log2_side;
  ivec3 corner = corner_of(ray, traversal.cell, span);
  ivec3 face = corner + (ray.ahead & side);
  real3 t = times_of(ray, real3(face));
  real earliest = min(min(t.x, t.y), t.z);
  bvec3 may_be_first = lessThanEqual(t, real3(earliest + (earliest * ROUNDINGS + ray.t_error)));
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
    traversal.cell = range.least;
    traversal.axis = crossing.axis;
  }
  return traversal;
}

const int FEW_RESOLVED_STEPS = 2;
int steps_resolved =
    0; // How many steps of the ray were resolved outside of the loops. Not of Traversal, which the first dispatch has too.

// Resolves the step of a traversal that is pending.
void resolve_step(const Ray ray, inout Traversal traversal) {
  EmptySpan span = EmptySpan(traversal.pending_step & 31, traversal.pending_step >> 5);
  traversal.pending_step = NO_PENDING_STEP;
  traversal.cell = ~traversal.cell;
  if (!(IEEE || NEAREST) || REFINES) {
    traversal = exact_step(ray, traversal, span);
    return;
  }
  // A loop, through which no lane goes where these tell.
  if (NEAREST) {
    for (bool is_left = !step_compensated(ray, traversal, span); is_left; is_left = false)
      traversal = exact_step(ray, traversal, span);
    return;
  }
  ++steps_resolved;
  // A loop, as above.
  for (bool is_left = !step_by_doubles(ray, traversal, span); is_left; is_left = false)
    traversal = exact_step(ray, traversal, span);
}
