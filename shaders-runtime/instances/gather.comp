// Keeps of what each ray has hit the nearest, and lists the rays that are not done. One invocation a ray.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "world.glsl"

// The least t, of the same the first instance.
bool is_nearer(uint t, uint instance, uint hit) {
  uint nearest = hit_words[hit + 6u];
  return nearest == NO_INSTANCE || t < hit_words[hit + 4u] || (t == hit_words[hit + 4u] && instance < nearest);
}

void keep(uint from, uint instance, uint hit) {
  for (uint word = 0u; word < 6u; ++word)
    hit_words[hit + word] = scratch[from + word];
  hit_words[hit + 6u] = instance;
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= (round == 0u ? tile_rays : scratch[ACTIVE_COUNT]))
    return;
  uint ray = round == 0u ? index : scratch[list_at(round & 1u) + index];
  uint slot = scratch[first_candidate_at(ray)], volume = scratch[first_candidate_at(ray) + 1u];
  bool more = volume >= MORE;
  volume &= ~MORE;
  uint hit = HIT_WORDS * (first_ray + ray);
  bool is_cut = false;
  while (slot != NO_SLOT) {
    uint from = candidate_hit_at(volume) + 6u * slot;
    int x = int(scratch[from]);
    uint instance = scratch[candidate_instance_at(volume) + slot];
    is_cut = is_cut || x < -1;
    if (x >= 0 && is_nearer(scratch[from + 4u], instance, hit))
      keep(from, instance, hit);
    uint next = next_candidate_at(volume, slot);
    slot = scratch[next];
    volume = scratch[next + 1u];
  }
  if (is_cut)
    hit_words[hit] = UNFINISHED;
  if (is_cut || !more)
    return;
  uint at = ray_at(ray);
  uint tmax = tmax_left(at, hit);
  float moment = uintBitsToFloat(scratch[key_at(ray)]);
  if (tmax <= INFINITY_BITS && moment - moment * MOMENT_ROUNDING > moment_of(tmax, direction_of(at), start_of(at)))
    return;
  uint place = atomicAdd(scratch[NEXT_COUNT], 1u);
  scratch[list_at((round + 1u) & 1u) + place] = ray;
}
