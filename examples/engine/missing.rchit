#version 460
// A chunk that is not loaded asks for itself: the host loads it before the next frame.
#extension GL_EXT_ray_tracing : require
#extension GL_GOOGLE_include_directive : require
#include "shared.glsl"
layout(location = 0) rayPayloadInEXT Payload payload;

void main() {
  wanted[gl_InstanceCustomIndexEXT] = 1u;
  payload = Payload(vec3(0.0), gl_HitTEXT, ivec3(-1), 0xff808080u);
}
