// Rays and hits in their buffers. `at` is where the words of a hit begin: six for each ray.

// What is stored of a ray: a hit, or where its traversal was left.
struct HitWords {
  uvec3 voxel;
  uint rgba;
  uint t;
  uint last; // Lookups or words read, else a face.
};

// Where a ray with bounds begins, of eight words each.
INLINE uint ray_at(uint at) { return BOUNDED ? at / 6u * 8u : at; }

uvec3 load_origin(uint at) { return uvec3(ray_words[ray_at(at)], ray_words[ray_at(at) + 1u], ray_words[ray_at(at) + 2u]); }
uint load_tmin(uint at) { return ray_words[ray_at(at) + 3u]; }
uvec3 load_direction(uint at) {
  uint first = ray_at(at) + (BOUNDED ? 4u : 3u);
  return uvec3(ray_words[first], ray_words[first + 1u], ray_words[first + 2u]);
}
uint load_tmax(uint at) { return ray_words[ray_at(at) + 7u]; }

void store_hit(uint at, const HitWords hit) {
  hit_words[at] = hit.voxel.x;
  hit_words[at + 1u] = hit.voxel.y;
  hit_words[at + 2u] = hit.voxel.z;
  hit_words[at + 3u] = hit.rgba;
  hit_words[at + 4u] = hit.t;
  hit_words[at + 5u] = hit.last;
}

HitWords load_hit(uint at) {
  uvec3 voxel = uvec3(hit_words[at], hit_words[at + 1u], hit_words[at + 2u]);
  return HitWords(voxel, hit_words[at + 3u], hit_words[at + 4u], hit_words[at + 5u]);
}
