// The first voxel on a ray, in exact arithmetic; what `closest` gives where there are no bounds.
%if paged
// If ${prefix}lacks_page after it, the ray has not found its end, and its hit is the cell in which it waits, with no colour.
%end
bool ${prefix}first(vec3 origin, vec3 direction, out ${prefix}Hit hit) {
  uvec3 from = floatBitsToUint(origin);
  uvec3 way = floatBitsToUint(direction);
%if paged
  lacks_page = false;
%end
  uint root = load_word(0u); // Leads to level 1, unless the volume is empty.
  Ray ray;
  Walk walk = walk_at(ivec3(-1));
  bool found = begin_walk(from, way, root, ray, walk) && is_in_volume(walk.cell) && walk_on(ray, walk, root);
  found = end_walk(from, way, walk, found);
  hit = miss();
%if paged
  if (found || (lacks_page && is_in_volume(walk.cell)))
    hit = hit_of(ray, walk);
  return found && !lacks_page;
%else
  if (found)
    hit = hit_of(ray, walk);
  return found;
%end
}
