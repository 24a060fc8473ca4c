// What rays see of a volume of which nothing is cut away; the same functions as those of cut.glsl.
bool seen_between(vec3 origin, vec3 direction, float tmin, float tmax, out voxc_scene_Hit hit) {
  return voxc_scene_first(0, origin, direction, hit);
}

bool seen_first(vec3 origin, vec3 direction, bool is_light, out voxc_scene_Hit hit) { return voxc_scene_first(0, origin, direction, hit); }

bool lies_at_cut(float t) { return false; }

// There is no such plane; some compilers refuse a direction of no length all the same.
const vec3 cut_normal = vec3(0.0, 1.0, 0.0);
const float cut_t = 0.0;
