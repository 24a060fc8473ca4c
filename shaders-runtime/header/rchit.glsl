#version 460
// voxc_format.rchit: what the closest hit tells whoever has traced the ray.
#extension GL_EXT_ray_tracing : require
#extension GL_EXT_buffer_reference : require
#extension GL_GOOGLE_include_directive : require

layout(buffer_reference, std430, buffer_reference_align = 4) readonly buffer Words { uint words[]; };
layout(shaderRecordEXT, std430) buffer Record { Words volume; };

#define VOXC_VOLUME Words
#define VOXC_LOAD(volume, index) volume.words[index]
#include "voxc_format.h"

hitAttributeEXT voxc_format_Hit reached;

struct Payload {
  vec3 normal; // In the world, of unit length, against the ray.
  float t;     // That of the ray; a miss shader has none to give.
  ivec3 voxel;
  uint colour; // R in the lowest byte, then G, B and A; or a label.
};
layout(location = 0) rayPayloadInEXT Payload payload;

void main() {
  vec3 normal = reached.axis < 0 ? -gl_ObjectRayDirectionEXT : voxc_format_normal(reached);
  payload.normal = normalize((normal * gl_WorldToObjectEXT).xyz);
  payload.t = gl_HitTEXT;
  payload.voxel = reached.voxel;
  payload.colour = reached.colour;
}
