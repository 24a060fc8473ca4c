#version 460
// The octahedron: the bits of a triangle's number say in which octant it lies.
#extension GL_EXT_ray_tracing : require
#extension GL_GOOGLE_include_directive : require
#include "shared.glsl"
layout(location = 0) rayPayloadInEXT Payload payload;

void main() {
  vec3 octant = vec3(gl_PrimitiveID & 1, gl_PrimitiveID >> 1 & 1, gl_PrimitiveID >> 2 & 1) * 2.0 - 1.0;
  payload = Payload(normalize(octant), gl_HitTEXT, ivec3(-1), 0xff3060e0u);
}
