// Steps from one cell of the ray to the next.

// Ends a step over the gap around the walk's cell, or over that and more, which leads to another cell if that is sure.
void end_step(const Ray ray, inout Walk walk, const Exit leaving, ivec3 cell, const Gap gap) {
  walk.axis = leaving.passed.z ? 2 : leaving.passed.y ? 1 : 0;
  if (!EXACT) {
    walk.cell = cell;
    count_step(walk);
    return;
  }
  bool sure = leaving.sure;
  if (REFINES) {
    walk.cell = sure ? cell : walk.cell;
    if (!sure)
      sure = step_compensated(ray, walk, gap);
    cell = walk.cell;
  }
  // A ray of whole numbers has to be settled at nearly each step: after a few, doubles tell these as they come. A loop, as devices of
  // wide vectors run through both ways of a branch, but not through a loop that no lane enters.
  if (EXACT && IEEE && !REFINES && SETTLES) {
    walk.cell = sure ? cell : walk.cell;
    for (bool is_asked = !sure && settlings > FEW_SETTLINGS; is_asked; is_asked = false)
      sure = step_by_doubles(ray, walk, gap);
    cell = sure ? walk.cell : cell;
  }
  // A step that is not sure is left open, and all loops end: what settles it stands outside of them, where lanes
  // that are sure need not wait for it.
  walk.cell =
      KEEPS_CELL || sure ? cell : ~walk.cell; // The next turn may read what is there before it is known if the step is sure.
  walk.open = sure ? CLOSED : gap.count << 5 | gap.log2_side;
  count_step(walk);
}

// Puts a walk whose step was left open outside, by the cell from which that leads.
void put_outside(inout Walk walk, ivec3 before) { walk.cell = walk.open >= 0 ? ~before : walk.cell; }

// Steps over the gap around the walk's cell, of which these faces lie ahead.
void step_over(const Ray ray, inout Walk walk, const Gap gap, real3 face) {
  Exit leaving = leave(ray, face);
  ivec3 cell = cell_beyond(ray, walk.cell, face, leaving);
  end_step(ray, walk, leaving, cell, gap);
}

// Steps over the gap around the walk's cell.
void step_over(const Ray ray, inout Walk walk, const Gap gap) {
  step_over(ray, walk, gap, real3(faces_ahead(ray, walk.cell, gap)));
}

// Steps over the empty cube of 2^log2_side voxels a side around the walk's cell.
void step_over(const Ray ray, inout Walk walk, int log2_side) { step_over(ray, walk, Gap(log2_side, 1)); }

// Steps from the walk's voxel, which is empty, to the next.
void step_over_voxel(const Ray ray, inout Walk walk) {
  ivec3 before = walk.cell;
  Exit leaving = leave(ray, real3(walk.cell - ray.ahead));
  end_step(ray, walk, leaving, walk.cell + mix(ivec3(0), ray.heading, leaving.passed), Gap(0, 1));
  if (KEEPS_CELL)
    put_outside(walk, before);
}
