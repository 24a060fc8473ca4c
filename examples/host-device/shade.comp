#version 460
// The nearest hit of each pixel, lit by the face that its ray enters.
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "frame.glsl"

const vec3 SUN = normalize(vec3(0.5, 0.8, 0.3));

vec3 normal_of(uint volume, uint face) {
  vec3 normal = vec3(0.0);
  if (face < 6u)
    normal[face / 2u] = (face & 1u) != 0u ? 1.0 : -1.0;
  return normalize(normal * mat3(to_volume[volume])); // By the transposed matrix, as normals go.
}

vec3 sky(vec3 direction) { return mix(vec3(0.93, 0.95, 1.0), vec3(0.38, 0.56, 0.85), 0.5 + 0.5 * normalize(direction).y); }

void main() {
  uvec2 at = gl_GlobalInvocationID.xy;
  if (at.x >= width || at.y >= height)
    return;
  uint pixel = at.y * width + at.x;
  vec3 colour = sky(direction_of(at));
  float nearest = uintBitsToFloat(0x7f800000u);
  for (uint volume = 0u; volume < VOLUMES; volume++) {
    Hit hit = hits[volume * rays_of_volume + pixel];
    if (hit.voxel[0] < 0 || hit.t >= nearest)
      continue;
    nearest = hit.t;
    float light = 0.35 + 0.65 * max(dot(normal_of(volume, hit.face), SUN), 0.0);
    colour = unpackUnorm4x8(hit.rgba).rgb * light;
  }
  pixels[pixel] = packUnorm4x8(vec4(colour, 1.0));
}
