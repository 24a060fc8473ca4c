#version 460
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Words { uvec2 digest; uint words[]; };
#define VOXC_VOLUME uint
#define VOXC_LOAD(volume, index) words[index]
#include "voxc_deep.h"

void main() {
  voxc_deep_Hit hit;
  if (digest == VOXC_DEEP_STORAGE_DIGEST && voxc_deep_closest(0u, vec3(0.0), vec3(1.0), 0.0, 1.0, hit))
    words[0] = 1u;
}
