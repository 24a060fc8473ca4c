// What all shaders of a frame share: as in main.cpp.
const uint VOLUMES = 2u;

struct Ray { // voxc::Ray
  float origin[3];
  float direction[3];
};

struct Hit { // voxc::Hit
  int voxel[3];
  uint rgba;
  float t;
  uint face;
};

layout(std430, binding = 0) readonly buffer Frame {
  mat4 to_volume[VOLUMES]; // From the world to the voxels of each.
  vec4 eye;
  vec4 right; // From the middle of the picture to its edges.
  vec4 up;
  vec4 forward;
  uint width, height;
  uint rays_of_volume; // Those of the second volume begin here.
};
layout(std430, binding = 1) buffer Rays { Ray rays[]; };
layout(std430, binding = 2) readonly buffer Hits { Hit hits[]; };
layout(std430, binding = 3) writeonly buffer Picture { uint pixels[]; };

vec3 direction_of(uvec2 pixel) {
  vec2 at = 2.0 * (vec2(pixel) + 0.5) / vec2(width, height) - 1.0;
  return forward.xyz + at.x * right.xyz - at.y * up.xyz;
}
