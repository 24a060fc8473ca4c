// From a ray to its walk, and the end of the walk.

// A ray that goes nowhere can hit its own cell alone: it is let go anywhere, and takes no later hit.
bool goes_nowhere(uvec3 direction) { return ((direction.x | direction.y | direction.z) & ~SIGN_BIT) == 0u; }

// Makes a ray ready, and its walk too, if that has not begun. False if there is nothing to walk through, or if the ray is left.
bool begin_walk(uvec3 origin, uvec3 direction, uint root, out Ray ray, inout Walk walk) {
  bool stays = SETTLES && goes_nowhere(direction);
  bool ordinary;
  ray = prepare_ray(origin, stays ? uvec3(floatBitsToUint(1.0f), 0u, 0u) : direction, ordinary);
  if (root == 0u)
    return false;
  if (SETTLES && !(are_finite(origin) && are_finite(direction)))
    return false;
  Walk start = walk;
  bool enters = enter_volume(ray, start, ordinary);
  // One that has waited for a page keeps its cell, where only who settles can tell how it entered.
  if (PAGED && start.open == AGAIN && is_in_volume(walk.cell)) {
    walk.open = AGAIN;
    return false;
  }
  bool may_have_begun = PACKETS || SETTLES; // A dispatch that does not settle begins all its rays.
  bool has_begun = may_have_begun && (is_in_volume(walk.cell) || walk.open != CLOSED);
  if (!enters || !has_begun)
    walk = start;
  return enters;
}

// What becomes of a hit: a ray that goes nowhere loses what is not in its own cell, once its walk has begun.
bool end_walk(uvec3 origin, uvec3 direction, inout Walk walk, bool hit) {
  bool may_stay = PACKETS || SETTLES; // Packets go on with rays that exact arithmetic has prepared.
  if (!may_stay || !goes_nowhere(direction) || walk.open == AGAIN || walk.cell == floor_of(origin))
    return hit;
  walk.cell = ivec3(-1);
  walk.open = CLOSED;
  return false;
}
