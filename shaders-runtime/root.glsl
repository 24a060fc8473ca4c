// The whole volume: word 0 leads to level 1, unless the volume is empty.
bool intersect_root(const Ray ray, inout Walk walk) {
  uint root = load_word(0u);
  return root != 0u && enter_volume(ray, walk, VOLUME_SIZE) && intersect_level_1(ray, walk, root, ivec3(0));
}

bool is_finite(vec3 v) { return all(lessThan(abs(v), vec3(INFINITY))); }

// Traces one ray; on a hit, walk.t is that of the ray as it was given.
bool trace(vec3 origin, vec3 direction, inout Walk walk) {
  if (!is_finite(origin) || !is_finite(direction))
    return false;
  float scale = direction_scale(direction);
  Ray ray = prepare_ray(origin, direction * scale);
  // A ray that goes nowhere can hit its own cell alone: let it go anywhere and take no later hit.
  bool stands = !any(ray.moves);
  if (stands)
    ray = prepare_ray(origin, vec3(1.0, 0.0, 0.0));
  bool hit = intersect_root(ray, walk) && !(stands && walk.t > 0.0);
  walk.t *= scale;
  return hit;
}

vec3 load_vector(uint at) { return vec3(ray_floats[at], ray_floats[at + 1u], ray_floats[at + 2u]); }

void main() {
  if (gl_GlobalInvocationID.x >= ray_count)
    return;
  uint at = 6u * (first_ray + gl_GlobalInvocationID.x);
  Walk walk = Walk(ivec3(0), 0.0, 0u, 0u);
  bool hit = trace(load_vector(at), load_vector(at + 3u), walk);
  hit_words[at] = hit ? uint(walk.cell.x) : 0xffffffffu;
  hit_words[at + 1u] = hit ? uint(walk.cell.y) : 0xffffffffu;
  hit_words[at + 2u] = hit ? uint(walk.cell.z) : 0xffffffffu;
  hit_words[at + 3u] = hit ? walk.rgba : 0u;
  hit_words[at + 4u] = hit ? floatBitsToUint(walk.t) : 0u;
  hit_words[at + 5u] = walk.lookups;
}
