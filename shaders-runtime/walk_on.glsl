// Goes on with a walk to its end, or until it is left.
bool walk_on(const Ray ray, inout Walk walk, uint root) {
%if exact
  bool hit = false;
  bool goes_on = true;
  while (goes_on) {
    while (SETTLES && walk.open >= 0)
      settle_step(ray, walk);
    // What was settled may have been the last step inside.
    hit = is_in_volume(walk.cell) && intersect_level_1(ray, walk, root);
    goes_on = SETTLES && walk.open >= 0;
  }
  return hit;
%else
  return intersect_level_1(ray, walk, root);
%end
}
