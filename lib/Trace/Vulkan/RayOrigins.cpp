// Where rays begin.
#include "RayOrigins.h"

#include <algorithm>
#include <cmath>

namespace voxc {

Origins originsOf(const RaySpan &rays, Int3 extent) {
  constexpr std::size_t kLooks = 1000;
  const float farAway = 2 * static_cast<float>(std::max({extent.x, extent.y, extent.z}));
  const std::size_t looks = std::min(rays.size(), kLooks);
  for (std::size_t look = 0; look < looks; ++look) {
    const float *const origin = rays.origin(rays.size() * look / looks);
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(origin[axis]) > farAway)
        return Origins::Anywhere;
  }
  return Origins::Near;
}

} // namespace voxc
