// What rays see of a volume of which planes cut something away: the first voxel that they enter where all planes keep it. The
// planes are PLANES, PLANE_COUNT of them: dot(p, xyz) is w or more where they keep a point p.

// Of the latest ray: the plane through which it enters what is kept, and when; 0 if it begins there.
vec3 cut_normal; // To what is cut away, in voxels.
float cut_t;

bool seen_between(vec3 origin, vec3 direction, float tmin, float tmax, out voxc_scene_Hit hit) {
  return voxc_scene_closest(0, origin, direction, tmin, tmax, hit);
}

// Before a moment by a few roundings: of faces in a plane rays see those that what is kept has, and not those of what is cut away.
float just_before(float t) {
  t = clamp(t, -1e36, 1e36);
  return t - abs(t) * (1.0 / 1048576.0) - 1e-30;
}

// A ray from the eye does not see the voxel in which it begins; one to the light does.
bool seen_first(vec3 origin, vec3 direction, bool is_light, out voxc_scene_Hit hit) {
  float tmin = is_light ? 0.0 : uintBitsToFloat(0x800000u), tmax = uintBitsToFloat(0x7f7fffffu);
  cut_normal = vec3(0.0);
  cut_t = 0.0;
  for (int i = 0; i < PLANE_COUNT; i++) {
    vec3 normal = PLANES[i].xyz;
    float side = dot(normal, origin) - PLANES[i].w, speed = dot(normal, direction), t = -side / speed;
    if (speed > 0.0) {
      tmin = max(tmin, just_before(t));
      cut_normal = t > cut_t ? -normalize(normal) : cut_normal;
      cut_t = max(cut_t, t);
    } else if (speed < 0.0) {
      tmax = min(tmax, just_before(t));
    } else if (!(side >= 0.0)) {
      tmax = -1.0;
    }
  }
  return voxc_scene_closest(0, origin, direction, tmin, tmax, hit);
}

// Whether what is seen lies right behind that plane; its light is then that of the plane.
bool lies_at_cut(float t) { return cut_t > 0.0 && t - cut_t <= length(SPACING); }
