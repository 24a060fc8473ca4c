// The first voxel on a ray, in exact arithmetic; what `closest` gives where there are no bounds.
bool ${prefix}first(vec3 origin, vec3 direction, out ${prefix}Hit hit) {
  uvec3 from = floatBitsToUint(origin);
  uvec3 way = floatBitsToUint(direction);
  uint root = load_word(0u); // Leads to level 1, unless the volume is empty.
  Ray ray;
  Walk walk = walk_at(ivec3(-1));
  bool found = begin_walk(from, way, root, ray, walk) && is_in_volume(walk.cell) && walk_on(ray, walk, root);
  found = end_walk(from, way, walk, found);
  hit = miss();
  if (found)
    hit = hit_of(ray, walk);
  return found;
}
