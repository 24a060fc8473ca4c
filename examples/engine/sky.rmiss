#version 460
// What a ray tells that meets nothing.
#extension GL_EXT_ray_tracing : require
#extension GL_GOOGLE_include_directive : require
#include "shared.glsl"
layout(location = 0) rayPayloadInEXT Payload payload;

void main() { payload = Payload(vec3(0.0), 0.0, ivec3(-1), 0u); }
