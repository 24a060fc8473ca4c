// Steps from one cell of the ray to the next.

// Ends a step from the walk's cell over empty cubes in the cube of 2^log2_side voxels a side at `corner`, to which a crossing
// leads.
void land_or_settle(const Ray ray, inout Walk walk, const Crossing crossing, ivec3 corner, int log2_side, bool sure) {
%if exact
  bool decided = sure;
  land(ray, walk, crossing, corner, 1 << log2_side, decided);
%if settles-outside
  // A step of which float32 is not sure is left open, and the cell is put outside, so that all loops end: what settles it
  // stands outside of them, where lanes that are sure need not wait for it.
  walk.cell = decided ? walk.cell : ~walk.cell;
  walk.open = decided ? -1 : log2_side;
%else
  if (!decided)
    walk = settled(ray, walk, log2_side);
%end
%else
  land(ray, walk, crossing, corner, 1 << log2_side);
%end
  count_step(walk);
}

// Steps over the empty cube of 2^log2_side voxels a side around the walk's cell.
void step_over(const Ray ray, inout Walk walk, int log2_side) {
  int side = 1 << log2_side;
  ivec3 corner = corner_of(walk.cell, log2_side);
  bool sure;
  Crossing crossing = leave_cube(ray, corner, side, sure);
  land_or_settle(ray, walk, crossing, corner + crossing.step * side, log2_side, sure);
}
