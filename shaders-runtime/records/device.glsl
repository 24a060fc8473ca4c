// Rays and hits in their buffers. `at` is where the words of a hit begin: six for each ray.

// What is stored of a ray: a hit, or where its traversal was left.
struct HitWords {
  uvec3 voxel;
  uint rgba;
  uint t;
  uint last; // Lookups or words read, else a face.
};

// A device loads and stores several words at once in the time of one.
uvec4 first_half(uint at) { return ray_halves[at / 6u * 2u]; }
uvec4 second_half(uint at) { return ray_halves[at / 6u * 2u + 1u]; }

uvec3 load_origin(uint at) {
  if (BOUNDED)
    return first_half(at).xyz;
  uvec2 first = ray_pairs[at / 2u], second = ray_pairs[at / 2u + 1u];
  return uvec3(first, second.x);
}

uvec3 load_direction(uint at) {
  if (BOUNDED)
    return second_half(at).xyz;
  uvec2 second = ray_pairs[at / 2u + 1u], third = ray_pairs[at / 2u + 2u];
  return uvec3(second.y, third);
}

uint load_tmin(uint at) { return first_half(at).w; }
uint load_tmax(uint at) { return second_half(at).w; }

void store_hit(uint at, const HitWords hit) {
  hit_pairs[at / 2u] = hit.voxel.xy;
  hit_pairs[at / 2u + 1u] = uvec2(hit.voxel.z, hit.rgba);
  hit_pairs[at / 2u + 2u] = uvec2(hit.t, hit.last);
}

HitWords load_hit(uint at) {
  uvec2 first = hit_pairs[at / 2u], second = hit_pairs[at / 2u + 1u], third = hit_pairs[at / 2u + 2u];
  return HitWords(uvec3(first, second.x), second.y, third.x, third.y);
}
