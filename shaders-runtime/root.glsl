// The whole volume: word 0 leads to level 1, unless the volume is empty. A walk that starts outside is first put into it.
bool intersect_root(const Ray ray, inout Walk walk) {
  uint root = load_word(0u);
  if (root == 0u || (!is_inside(walk) && !enter_volume(ray, walk, VOLUME_SIZE)))
    return false;
  return intersect_level_1(ray, walk, root, ivec3(0));
}

bool is_finite(vec3 v) { return all(lessThan(abs(v), vec3(INFINITY))); }

// Traces one ray from where its walk is; walk.t is that of the ray as it was given.
bool trace(vec3 origin, vec3 direction, inout Walk walk) {
  if (!is_finite(origin) || !is_finite(direction))
    return false;
  float scale = direction_scale(direction);
  Ray ray = prepare_ray(origin, direction * scale);
  // A ray that goes nowhere can hit its own cell alone: let it go anywhere and take no later hit.
  bool stands = !any(ray.moves);
  if (stands)
    ray = prepare_ray(origin, vec3(1.0, 0.0, 0.0));
  walk.t /= scale;
  bool hit = intersect_root(ray, walk);
  if (stands && walk.t > 0.0) {
    hit = false;
    walk.cell = ivec3(-1);
  }
  walk.t *= scale;
  return hit;
}
