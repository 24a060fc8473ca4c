// Steps from one cell of the ray to the next.

// Ends a step over the empty span around the traversal's cell, or over that and more, which leads to another cell if that is sure.
void end_step(const Ray ray, inout Traversal traversal, const Exit leaving, ivec3 cell, const EmptySpan span) {
  traversal.axis = leaving.passed.z ? 2 : leaving.passed.y ? 1 : 0;
  if (!EXACT) {
    traversal.cell = cell;
    count_step(traversal);
    return;
  }
  bool sure = leaving.sure;
  if (REFINES) {
    traversal.cell = sure ? cell : traversal.cell;
    if (!sure)
      sure = step_compensated(ray, traversal, span);
    cell = traversal.cell;
  }
  // A ray of whole numbers has to be resolved at nearly each step: after a few, doubles decide these as they come. A loop, as devices of
  // wide vectors run through both ways of a branch, but not through a loop that no lane enters.
  if (EXACT && IEEE && !REFINES && EXACT_FALLBACK) {
    traversal.cell = sure ? cell : traversal.cell;
    for (bool is_asked = !sure && steps_resolved > FEW_RESOLVED_STEPS; is_asked; is_asked = false)
      sure = step_by_doubles(ray, traversal, span);
    cell = sure ? traversal.cell : cell;
  }
  // A step that is not sure is left pending, and all loops end: what resolves it stands outside of them, where lanes
  // that are sure need not wait for it.
  traversal.cell =
      KEEPS_CELL || sure ? cell : ~traversal.cell; // The next turn may read what is there before it is known if the step is sure.
  traversal.pending_step = sure ? NO_PENDING_STEP : span.count << 5 | span.log2_side;
  count_step(traversal);
}

// Puts a traversal whose step was left open outside, by the cell from which that leads.
void put_outside(inout Traversal traversal, ivec3 before) {
  traversal.cell = traversal.pending_step >= 0 ? ~before : traversal.cell;
}

// Steps over the empty span around the traversal's cell, of which these faces lie ahead.
void step_over(const Ray ray, inout Traversal traversal, const EmptySpan span, real3 face) {
  Exit leaving = leave(ray, face);
  ivec3 cell = cell_beyond(ray, traversal.cell, face, leaving);
  end_step(ray, traversal, leaving, cell, span);
}

// Steps over the empty span around the traversal's cell.
void step_over(const Ray ray, inout Traversal traversal, const EmptySpan span) {
  step_over(ray, traversal, span, real3(faces_ahead(ray, traversal.cell, span)));
}

// Steps over the empty cube of 2^log2_side voxels a side around the traversal's cell.
void step_over(const Ray ray, inout Traversal traversal, int log2_side) { step_over(ray, traversal, EmptySpan(log2_side, 1)); }

// Steps from the traversal's voxel, which is empty, to the next.
void step_over_voxel(const Ray ray, inout Traversal traversal) {
  ivec3 before = traversal.cell;
  Exit leaving = leave(ray, real3(traversal.cell - ray.ahead));
  end_step(ray, traversal, leaving, traversal.cell + mix(ivec3(0), ray.heading, leaving.passed), EmptySpan(0, 1));
  if (KEEPS_CELL)
    put_outside(traversal, before);
}
