// The first voxel on a ray, in exact arithmetic; what `closest` gives where there are no bounds.
bool voxc_format_first(vec3 origin, vec3 direction, out voxc_format_Hit hit) {
  uvec3 from = floatBitsToUint(origin);
  uvec3 way = floatBitsToUint(direction);
  if (PAGED)
    lacks_page = false;      // A ray that waits for a word has the cell in which it waits for its hit, with no colour.
  uint root = load_word(0u); // Leads to level 1, unless the volume is empty.
  Ray ray;
  Traversal traversal = traversal_at(ivec3(-1));
  bool found = begin_traversal(from, way, root, ray, traversal) && is_in_volume(traversal.cell) &&
               continue_traversal(ray, traversal, root);
  found = end_traversal(from, way, traversal, found);
  hit = miss();
  if (found || (PAGED && lacks_page && is_in_volume(traversal.cell)))
    hit = hit_of(ray, traversal);
  return found && (!PAGED || !lacks_page);
}
