#version 460
// A ray for each pixel and volume, in the voxels of that volume. Directions are not made unit length, so that a t means the same
// in all volumes and in the world.
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "frame.glsl"

void main() {
  uvec3 at = gl_GlobalInvocationID;
  if (at.x >= width || at.y >= height)
    return;
  vec3 origin = vec3(to_volume[at.z] * vec4(eye.xyz, 1.0));
  vec3 direction = mat3(to_volume[at.z]) * direction_of(at.xy);
  rays[at.z * rays_of_volume + at.y * width + at.x] =
      Ray(float[](origin.x, origin.y, origin.z), float[](direction.x, direction.y, direction.z));
}
