// Says how many groups the kernels of the volumes are started with, and fills the last group of each with rays that miss.
// One group.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "world.glsl"

void main() {
  uint lane = gl_LocalInvocationID.x;
  for (uint volume = 0u; volume < VOLUMES; ++volume) {
    uint starts = starts_of(volume);
    uint rays = min(scratch[starts + 3u], most_rays);
    uint groups = (rays + 63u) / 64u;
    if (lane == 0u) {
      scratch[starts] = groups;
      scratch[starts + 1u] = scratch[starts + 2u] = 1u;
    }
    // No kernel finds anything for a ray that is no number.
    uint slot = rays + lane;
    if (slot < 64u * groups)
      for (uint word = 0u; word < words_of_ray(volume); ++word)
        scratch[candidate_ray_at(volume) + words_of_ray(volume) * slot + word] = NAN_BITS;
  }
}
