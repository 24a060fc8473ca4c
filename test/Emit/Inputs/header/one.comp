#version 460
// One header, alone, with a volume that is an address.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
layout(local_size_x = 64) in;
layout(buffer_reference, std430, buffer_reference_align = 4) readonly buffer Words { uint words[]; };
layout(push_constant) uniform Push { Words volume; };
layout(std430, binding = 0) buffer Results { float results[]; };
#define VOXC_VOLUME Words
#define VOXC_LOAD(volume, index) volume.words[index]
#include "voxc_r2_2_2_g3.h"

void main() {
  uint number = gl_GlobalInvocationID.x;
  voxc_r2_2_2_g3_Hit hit;
  bool found = voxc_r2_2_2_g3_closest(volume, vec3(-1.0, number, 2.0), vec3(1.0, 0.1, 0.2), 0.0, 1e30, hit);
  results[number] = found ? hit.t : -1.0;
}
