// Goes on with a traversal to its end, or until it is left.
bool continue_traversal(const Ray ray, inout Traversal traversal, uint root) {
  if (!EXACT)
    return intersect_level_1(ray, traversal, root);
  if (!EXACT_FALLBACK)
    return is_in_volume(traversal.cell) && intersect_level_1(ray, traversal, root);
  bool hit = false;
  bool is_under_way = true;
  while (is_under_way) {
    while (traversal.pending_step >= 0)
      resolve_step(ray, traversal);
    // What was resolved may have been the last step inside.
    hit = is_in_volume(traversal.cell) && intersect_level_1(ray, traversal, root);
    is_under_way = traversal.pending_step >= 0;
  }
  return hit;
}
