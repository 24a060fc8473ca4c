// From the buffers to a look-up, and back. A point is the origin of a ray, whose direction does not count.

// A voxel is told by itself, a place without one by -1, as misses are.
void store(uint at, ivec3 voxel, bool is_there, uint lookups) {
  uint last = COUNT_WORDS ? words_read : COUNT_LOOKUPS ? lookups : 0u;
  store_hit(at, HitWords(uvec3(is_there ? voxel : ivec3(-1)), 0u, 0u, last));
}

// Answers whether there is a voxel at a point.
void answer(uint at) {
  uvec3 point = load_origin(at);
  ivec3 voxel = floor_of(point);
  uint root = load_word(0u); // Leads to level 1, unless the volume is empty.
  bool looks = root != 0u && are_finite(point) && all(lessThan(uvec3(voxel), uvec3(VOLUME_SIZE)));
  store(at, voxel, looks && is_voxel_level_1(root, voxel), looks ? 1u : 0u);
}
