// Two formats in one program.
#include "voxc_r2_2_2_g3.h"
#include "voxc_second.h"

bool isLit(const unsigned int *first, const unsigned int *second) {
  voxc_r2_2_2_g3_Hit hit;
  if (!voxc_r2_2_2_g3_closest(first, {0, 0, 0}, {1, 2, 3}, 0, 100, hit))
    return true;
  return !voxc_second_any(second, {0, 0, 0}, {1, 2, 3}, 0, hit.t);
}
