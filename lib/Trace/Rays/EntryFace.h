// The face through which a ray enters the voxel that it hits.
#pragma once

#include "voxc/Trace/Ray.h"

namespace voxc {

struct EntryFace {
  int axis = -1;     ///< -1: the ray begins in the voxel.
  bool high = false; ///< It is the face at the voxel's high coordinate.
};

/// That of the axis whose slab the ray enters last.
inline EntryFace entryFace(const Ray &ray, const Hit &hit) {
  EntryFace face;
  if (hit.t == 0)
    return face;
  double latest = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const double direction = ray.direction[axis];
    if (direction == 0)
      continue;
    const double boundary = hit.voxel[axis] + (direction < 0 ? 1.0 : 0.0);
    const double entry = (boundary - ray.origin[axis]) / direction;
    if (entry > latest) {
      latest = entry;
      face = {axis, direction < 0};
    }
  }
  return face;
}

} // namespace voxc
