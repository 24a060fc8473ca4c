// Makes the list of rays that are not done the one that the next round is over. One group; after the last round, as many as
// the rays need, and what is not done then is said to be unfinished.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "world.glsl"

void main() {
  uint lane = gl_GlobalInvocationID.x;
  if (most == 0u) {
    if (lane < scratch[ACTIVE_COUNT])
      hit_words[HIT_WORDS * (first_ray + scratch[list_at(round & 1u) + lane])] = UNFINISHED;
    return;
  }
  if (lane != 0u)
    return;
  scratch[ACTIVE_COUNT] = scratch[NEXT_COUNT];
  scratch[NEXT_COUNT] = 0u;
  scratch[ACTIVE_GROUPS] = (scratch[ACTIVE_COUNT] + 63u) / 64u;
  scratch[ACTIVE_GROUPS + 1u] = scratch[ACTIVE_GROUPS + 2u] = 1u;
  for (uint volume = 0u; volume < VOLUMES; ++volume)
    scratch[starts_of(volume) + 3u] = 0u;
}
