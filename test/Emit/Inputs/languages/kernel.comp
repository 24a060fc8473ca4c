#version 460
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Words { uint words[]; };
layout(std430, binding = 1) buffer Times { float times[]; };
#define VOXC_VOLUME uint
#define VOXC_LOAD(volume, index) words[index]
#include "voxc_t.glsl"

void main() {
  voxc_t_Hit hit;
  bool found = voxc_t_closest(0u, vec3(gl_GlobalInvocationID), vec3(1.0f, 0.5f, 0.25f), 0.0f, 1e30f, hit);
  times[gl_GlobalInvocationID.x] = found ? hit.t : float(-voxc_t_VOLUME_SIZE.x);
}
