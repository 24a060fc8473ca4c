// Random rays.
#include "RandomRays.h"

namespace voxc::test {

std::vector<Ray> raysInto(Int3 extent, std::size_t count, std::mt19937 &random) {
  const float sides[] = {static_cast<float>(extent.x), static_cast<float>(extent.y),
                         static_cast<float>(extent.z)};
  std::vector<Ray> rays(count);
  for (Ray &ray : rays)
    for (int axis = 0; axis < 3; ++axis) {
      std::uniform_real_distribution<float> around(-sides[axis], 2 * sides[axis]), inside(0, sides[axis]);
      ray.origin[axis] = around(random);
      ray.direction[axis] = inside(random) - ray.origin[axis];
    }
  return rays;
}

} // namespace voxc::test
