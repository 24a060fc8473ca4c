#include "voxc_t.cuh"

extern "C" __attribute__((global)) void trace(const unsigned int *words, const float *rays, float *t) {
  voxc_t_Hit hit;
  const bool found = voxc_t_closest(words, {rays[0], rays[1], rays[2]}, {rays[3], rays[4], rays[5]}, 0.0f, 1e30f, hit);
  t[0] = found ? hit.t : float(-voxc_t_VOLUME_SIZE().x);
}
