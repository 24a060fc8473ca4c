// Rays along an axis, and rays through lattice points, where two or three boundaries are crossed at once.
#include "Points.h"
#include "RayKinds.h"

#include <algorithm>
#include <cmath>

namespace voxc::oracle {

Ray axisCentreRay(RandomSource &random, const RayTarget &target) { return axisParallel(random, target, 0); }
Ray axisFaceRay(RandomSource &random, const RayTarget &target) { return axisParallel(random, target, 1); }
Ray axisEdgeRay(RandomSource &random, const RayTarget &target) { return axisParallel(random, target, 2); }

Ray diagonalRay(RandomSource &random, const RayTarget &target) {
  Point point, direction;
  latticePoint(random, target, point);
  wholeDirection(random, direction);
  const Int3 extent = target.extent;
  const int longest = std::max({extent.x, extent.y, extent.z});
  const int steps = random.flip() ? 0 : random.integer(0, longest);
  Ray ray = backedOff(point, direction, static_cast<float>(steps));
  const float scale = std::ldexp(1.0f, random.integer(-3, 3));
  for (float &component : ray.direction)
    component *= scale;
  return ray;
}

} // namespace voxc::oracle
