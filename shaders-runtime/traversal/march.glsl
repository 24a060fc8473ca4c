// Steps from an empty cell to the first whose L1 distance is not below `left`, or that lies outside the sub-volume; no
// lookup is needed on the way.
void march_level(const Ray ray, inout Traversal traversal, int left) {
  const int side = 1 << LEVEL_LOG2_CELL;
  ivec3 face = corner_of(traversal.cell, LEVEL_LOG2_CELL) + (ray.ahead & side);
  ivec3 corner = face; // `left` is at least 1, which compilers cannot know.
  Exit leaving = Exit(0.0f, bvec3(false), true);
  // The condition stands at the head: Mesa 22.3's llvmpipe lets lanes that leave a loop further down run on.
  while (leaving.sure && left > 0) {
    face += side * mix(ivec3(0), ray.heading, leaving.passed);
    leaving = leave(ray, real3(face));
    ivec3 step = mix(ivec3(0), ray.heading, leaving.passed);
    corner = face + side * (step - (ray.ahead & 1));
    left = within_level(traversal.cell, corner) ? left - (abs(step.x) + abs(step.y) + abs(step.z)) : 0;
  }
  if (side > 1)
    corner = cell_beyond(ray, traversal.cell, real3(face), leaving);
  end_step(ray, traversal, leaving, corner, EmptySpan(LEVEL_LOG2_CELL, 1));
}
