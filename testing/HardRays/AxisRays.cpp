// Rays along an axis, exactly or almost, and just beside the planes between cells.
#include "Families.h"
#include "Points.h"

#include <algorithm>
#include <cmath>

namespace voxc::test {

Ray boundaryUlpRay(RandomSource &random, const RayTarget &target) {
  Ray ray = random.flip() ? axisParallel(random, target, random.integer(1, 2)) : diagonalRay(random, target);
  for (float &component : ray.origin)
    component = nudged(random, component);
  if (random.flip())
    for (float &component : ray.direction)
      component = nudged(random, component);
  return ray;
}

Ray grazingRay(RandomSource &random, const RayTarget &target) {
  Ray ray = axisParallel(random, target, random.integer(1, 2));
  for (float &component : ray.direction)
    if (component == 0 && random.flip())
      component = signedPower(random, -40, -2);
  return ray;
}

/// Parallel to a plane between cells but for 1e-7, which the ray meets somewhere on its way through the grid.
Ray grazingMeetRay(RandomSource &random, const RayTarget &target) {
  Ray ray = axisParallel(random, target, random.integer(1, 2));
  const int along =
      static_cast<int>(std::ranges::find_if(ray.direction, [](float d) { return d != 0; }) - ray.direction);
  const double way = random.real(0, 1) * target.extent[along];
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == along || random.integer(0, 3) == 0)
      continue;
    const double sign = random.sign(), slope = sign * random.real(0.5e-7, 4e-7);
    ray.direction[axis] = static_cast<float>(slope * std::abs(ray.direction[along]));
    ray.origin[axis] = static_cast<float>(ray.origin[axis] - slope * way);
  }
  return ray;
}

/// Through a tunnel of one cell's width along an axis, as the scene `tunnels` has them, from one end to the
/// other or into a wall just before the end; the walls are touched, or missed by an ulp.
Ray tunnelRay(RandomSource &random, const RayTarget &target) {
  const int along = random.integer(0, 2), length = target.extent[along];
  const bool up = random.flip();
  Ray ray{};
  ray.origin[along] =
      up ? -static_cast<float>(random.integer(0, 3)) : static_cast<float>(length + random.integer(0, 3));
  ray.direction[along] = up ? 1.0f : -1.0f;
  for (int turn = 1; turn < 3; ++turn) {
    const int axis = (along + turn) % 3;
    const int low =
        std::min(4 * random.integer(0, (target.extent[axis] - 1) / 4) + 1, target.extent[axis] - 1);
    const double start = random.integer(0, 2) == 0 ? random.real(0, 1) : random.integer(0, 1);
    const double end = random.integer(0, 2) == 0 ? random.real(0, 1) : random.integer(0, 1);
    ray.origin[axis] = nudged(random, static_cast<float>(low + start));
    ray.direction[axis] = static_cast<float>((end - start) / length);
  }
  return ray;
}

} // namespace voxc::test
