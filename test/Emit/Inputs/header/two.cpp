// Two formats in one program.
#include "voxc_r2_2_2_g3.h"
#include "voxc_second.h"

#if defined(VOXC_VOLUME) || defined(VOXC_LOAD) || defined(VOXC_IN) || defined(VOXC_INLINE)
#error a header leaves a macro behind
#endif
static_assert(sizeof(voxc_second_Hit) == 28);

bool isLit(const unsigned int *first, const unsigned int *second) {
  voxc_r2_2_2_g3_Hit hit;
  if (!voxc_r2_2_2_g3_closest(first, {0, 0, 0}, {1, 2, 3}, 0, 100, hit) || hit.voxel.x > voxc_r2_2_2_g3_VOLUME_SIZE.x)
    return true;
  return !voxc_second_any(second, {0, 0, 0}, {1, 2, 3}, 0, hit.t);
}
