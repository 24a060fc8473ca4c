// What shaders find in the text before them: the kernel's functions, what they are given, and textures.
struct voxc_scene_Hit {
  ivec3 voxel;
  float t;
  uint colour;
  int axis;
  int side;
};
bool voxc_scene_first(int volume, vec3 origin, vec3 direction, out voxc_scene_Hit hit);
bool voxc_scene_closest(int volume, vec3 origin, vec3 direction, float tmin, float tmax, out voxc_scene_Hit hit);
vec3 voxc_scene_normal(const voxc_scene_Hit hit);
vec3 voxc_scene_outside(vec3 origin, vec3 direction, const voxc_scene_Hit hit);

uniform Given given;
const bool IS_LABEL = false;
const vec3 SPACING = vec3(1.0);
const int PLANE_COUNT = 1;
const vec4 PLANES[1];

usampler2D before_sun;
usampler2D before_sky;
usampler2D sun_light;
usampler2D sky_light;
usampler2D told;
usampler2D rays;
usampler2D pairs;
uvec4 texelFetch(usampler2D texels, ivec2 at, int level);
