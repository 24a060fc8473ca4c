// From a ray to its traversal, and the end of the traversal.

// A ray that goes nowhere can hit its own cell alone: it is let go anywhere, and takes no later hit.
bool goes_nowhere(uvec3 direction) { return ((direction.x | direction.y | direction.z) & ~SIGN_BIT) == 0u; }

// Makes a ray ready, and its traversal too, if that has not begun. False if there is nothing to go through, or if the ray is left.
bool begin_traversal(uvec3 origin, uvec3 direction, uint root, out Ray ray, inout Traversal traversal) {
  bool stays = EXACT_FALLBACK && goes_nowhere(direction);
  bool ordinary;
  ray = prepare_ray(origin, stays ? uvec3(floatBitsToUint(1.0f), 0u, 0u) : direction, ordinary);
  if (root == 0u)
    return false;
  if (EXACT_FALLBACK && !(are_finite(origin) && are_finite(direction)))
    return false;
  Traversal start = traversal;
  bool enters = enter_volume(ray, start, ordinary);
  // One that has waited for a page keeps its cell, where only the exact fallback can decide how it entered.
  if (PAGED && start.pending_step == RETRY && is_in_volume(traversal.cell)) {
    traversal.pending_step = RETRY;
    return false;
  }
  bool may_have_begun = PACKETS || EXACT_FALLBACK; // A dispatch without the exact fallback begins all its rays.
  bool has_begun = may_have_begun && (is_in_volume(traversal.cell) || traversal.pending_step != NO_PENDING_STEP);
  if (!enters || !has_begun)
    traversal = start;
  return enters;
}

// What becomes of a hit: a ray that goes nowhere loses what is not in its own cell, once its traversal has begun.
bool end_traversal(uvec3 origin, uvec3 direction, inout Traversal traversal, bool hit) {
  bool may_stay = PACKETS || EXACT_FALLBACK; // Packets go on with rays that exact arithmetic has prepared.
  if (!may_stay || !goes_nowhere(direction) || traversal.pending_step == RETRY || traversal.cell == floor_of(origin))
    return hit;
  traversal.cell = ivec3(-1);
  traversal.pending_step = NO_PENDING_STEP;
  return false;
}
