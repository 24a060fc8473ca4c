#include "voxc_t.hpp"

float time_of(const unsigned int *words, const float *ray) {
  voxc_t_Hit hit;
  const bool found = voxc_t_closest(words, {ray[0], ray[1], ray[2]}, {ray[3], ray[4], ray[5]}, 0.0f, 1e30f, hit);
  return found ? hit.t : float(-voxc_t_VOLUME_SIZE.x);
}
