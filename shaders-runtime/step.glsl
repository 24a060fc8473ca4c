// Steps from one cell of the ray to the next.

// Ends a step from the walk's cell, over the gap there at least, in the cube of `side` voxels at `corner`, to which a crossing
// leads.
void land_or_settle(const Ray ray, inout Walk walk, const Crossing crossing, ivec3 corner, int side, const Gap gap, bool sure) {
%if exact
  bool decided = sure;
  land(ray, walk, crossing, corner, side, decided);
%if refines
  if (!decided)
    decided = step_by_doubles(ray, walk, gap);
%end
  // A step that is not sure is left open, and the cell is put outside, so that all loops end: what settles it
  // stands outside of them, where lanes that are sure need not wait for it.
  walk.cell = decided ? walk.cell : ~walk.cell;
  walk.open = decided ? CLOSED : gap.count << 5 | gap.log2_side;
%else
  land(ray, walk, crossing, corner, side);
%end
  count_step(walk);
}

// Steps over the gap around the walk's cell.
void step_over(const Ray ray, inout Walk walk, const Gap gap) {
  int side = gap.count << gap.log2_side;
  ivec3 corner = corner_of(ray, walk.cell, gap);
  bool sure;
  Crossing crossing = leave_cube(ray, corner, side, sure);
  land_or_settle(ray, walk, crossing, corner + crossing.step * side, side, gap, sure);
}

// Steps over the empty cube of 2^log2_side voxels a side around the walk's cell.
void step_over(const Ray ray, inout Walk walk, int log2_side) { step_over(ray, walk, Gap(log2_side, 1)); }
