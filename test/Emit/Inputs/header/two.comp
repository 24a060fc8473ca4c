#version 460
// Two formats in one shader, which has names of its own that are also inside of the headers.
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Volumes { uint words[]; } volumes[2];
layout(std430, binding = 1) buffer Results { float results[]; };
#define VOXC_VOLUME uint
#define VOXC_LOAD(volume, index) volumes[volume].words[index]
struct Ray { vec3 origin, direction; };
const ivec3 VOLUME_SIZE = ivec3(1);
#include "voxc_r2_2_2_g3.h"
#include "voxc_second.h"

void add(inout float sum, float more) { sum += more; }

void main() {
  uint number = gl_GlobalInvocationID.x;
  Ray ray = Ray(vec3(-1.0, number, 2.0), vec3(1.0, 0.1, 0.2));
  float sum = 0.0;
  voxc_r2_2_2_g3_Hit first;
  if (voxc_r2_2_2_g3_closest(0u, ray.origin, ray.direction, 0.0, 1e30, first))
    add(sum, dot(voxc_r2_2_2_g3_normal(first), ray.direction));
  voxc_second_Hit second;
  bool found = voxc_second_closest(1u, ray.origin, ray.direction, 0.0, first.t, second);
  for (; found; found = voxc_second_next(1u, ray.origin, ray.direction, first.t, second))
    add(sum, second.t + float(VOLUME_SIZE.x));
  results[number] = voxc_second_any(1u, ray.origin, -ray.direction, 0.5, 1.0) ? 0.0 : sum;
}
