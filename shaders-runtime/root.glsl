// From a ray to its walk, and the end of the walk.

// A ray that goes nowhere can hit its own cell alone: it is let go anywhere, and takes no later hit.
bool goes_nowhere(uvec3 direction) { return ((direction.x | direction.y | direction.z) & ~SIGN_BIT) == 0u; }

// Makes a ray ready, and its walk too, if that has not begun. False if there is nothing to walk through, or if the ray is left.
bool begin_walk(uvec3 origin, uvec3 direction, uint root, out Ray ray, inout Walk walk) {
  ray = prepare_ray(origin, goes_nowhere(direction) ? uvec3(floatBitsToUint(1.0f), 0u, 0u) : direction);
  if (root == 0u || !are_finite(origin) || !are_finite(direction))
    return false;
  if (!SETTLES && !ray.plain) {
    walk.open = AGAIN;
    return false;
  }
  Walk start = walk;
  bool enters = enter_volume(ray, start);
%if paged
  // One that has waited for a page keeps its cell, where only who settles can tell how it entered.
  if (start.open == AGAIN && is_in_volume(walk.cell)) {
    walk.open = AGAIN;
    return false;
  }
%end
  if (!enters || (!is_in_volume(walk.cell) && walk.open == CLOSED))
    walk = start;
  return enters;
}

// What becomes of a hit: a ray that goes nowhere loses what is not in its own cell, once its walk has begun.
bool end_walk(uvec3 origin, uvec3 direction, inout Walk walk, bool hit) {
  if (!goes_nowhere(direction) || walk.open == AGAIN || walk.cell == floor_of(origin))
    return hit;
  walk.cell = ivec3(-1);
  walk.open = CLOSED;
  return false;
}
