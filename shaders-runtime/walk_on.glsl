// Goes on with a walk to its end, or until it is left.
bool walk_on(const Ray ray, inout Walk walk, uint root) {
  if (!EXACT)
    return intersect_level_1(ray, walk, root);
  if (!SETTLES)
    return is_in_volume(walk.cell) && intersect_level_1(ray, walk, root);
  bool hit = false;
  bool is_under_way = true;
  while (is_under_way) {
    while (walk.open >= 0)
      settle_step(ray, walk);
    // What was settled may have been the last step inside.
    hit = is_in_volume(walk.cell) && intersect_level_1(ray, walk, root);
    is_under_way = walk.open >= 0;
  }
  return hit;
}
