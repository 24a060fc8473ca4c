// Traces one ray from where its walk is, if that has begun, and gives its t. Word 0 leads to level 1, unless the volume
// is empty.
bool trace(uvec3 origin, uvec3 direction, inout Walk walk, inout uint t) {
  uint root = load_word(0u);
  if (root == 0u || !are_finite(origin) || !are_finite(direction))
    return false;
  // A ray that goes nowhere can hit its own cell alone: let it go anywhere and take no later hit.
  bool stands = ((direction.x | direction.y | direction.z) & ~SIGN_BIT) == 0u;
  Ray ray = prepare_ray(origin, stands ? uvec3(floatBitsToUint(1.0f), 0u, 0u) : direction);
%if apart
  if (!SETTLES && !ray.plain) {
    walk.open = AGAIN;
    return false;
  }
%end
  Walk start = walk;
  if (!enter_volume(ray, start)) {
%if apart
    walk = start;
%end
    return false;
  }
  if (!is_in_volume(walk.cell) && ${is-closed})
    walk = start;
%if settles-outside
  bool hit = false;
  bool goes_on = true;
  while (goes_on) {
    while (SETTLES && walk.open >= 0) {
      Gap gap = Gap(walk.open & 31, walk.open >> 5);
      walk.open = CLOSED;
      walk.cell = ~walk.cell;
      walk = settled(ray, walk, gap);
    }
    // What was settled may have been the last step inside.
    hit = is_in_volume(walk.cell) && intersect_level_1(ray, walk, root);
    goes_on = SETTLES && walk.open >= 0;
  }
%else
  bool hit = intersect_level_1(ray, walk, root);
%end
  if (walk.axis < 0)
    return hit;
  if (stands) {
    walk.cell = ivec3(-1);
%if apart
    walk.open = CLOSED;
%end
    return false;
  }
  if (hit) {
    bool sure;
    t = crossing_time(ray, walk.axis, entered_face(ray, walk), sure);
%if apart
    hit = sure;
    walk.open = sure ? CLOSED : AGAIN;
%end
  }
  return hit;
}
