// Lines of chance: as of cameras, from outside, from inside.
#include "Points.h"
#include "RayKinds.h"

#include <cmath>

namespace voxc::oracle {

namespace {

/// A point of the grid; every other time one in a voxel of the target, if it has any.
void aimPoint(RandomSource &random, const RayTarget &target, Point &point) {
  if (target.voxels.empty() || random.flip())
    return randomPoint(random, target, point);
  const Int3 cell = randomCell(random, target);
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = static_cast<float>(cell[axis] + random.real(0, 1));
}

} // namespace

Ray outsideRay(RandomSource &random, const RayTarget &target) {
  Point origin, aim;
  randomPoint(random, target, origin, 1.5);
  aimPoint(random, target, aim);
  const int axis = random.integer(0, 2); // Off the grid on one axis at least.
  origin[axis] = static_cast<float>(random.flip() ? -random.real(0, 2) * target.extent[axis]
                                                  : random.real(1, 3) * target.extent[axis]);
  return between(origin, aim);
}

Ray insideRay(RandomSource &random, const RayTarget &target) {
  Point origin, aim;
  random.flip() ? randomPoint(random, target, origin) : latticePoint(random, target, origin);
  randomPoint(random, target, aim, 1);
  return between(origin, aim);
}

Ray cameraRay(RandomSource &random, const RayTarget &target) {
  Ray ray = outsideRay(random, target);
  const float *d = ray.direction;
  const double length = std::sqrt(double{d[0]} * d[0] + double{d[1]} * d[1] + double{d[2]} * d[2]);
  for (float &component : ray.direction)
    component = static_cast<float>(component / length);
  return ray;
}

} // namespace voxc::oracle
