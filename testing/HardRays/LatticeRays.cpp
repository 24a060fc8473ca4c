// Rays through lattice points, where two or three boundaries are crossed at once.
#include "Families.h"
#include "Points.h"

#include <algorithm>
#include <cmath>

namespace voxc::test {

/// Through a corner of the grid, or a lattice point of one of its edges.
Ray cornerRay(RandomSource &random, const RayTarget &target) {
  Point point, direction;
  latticePoint(random, target, point);
  const int free = random.integer(0, 3);
  for (int axis = 0; axis < 3; ++axis)
    if (axis != free)
      point[axis] = random.flip() ? static_cast<float>(target.extent[axis]) : 0.0f;
  wholeDirection(random, direction);
  return backedOff(point, direction, static_cast<float>(random.integer(0, 8)));
}

/// From or through a lattice point along whole components that share no small factor: further lattice points
/// are met exactly, and many are passed at a small distance.
Ray wholeRay(RandomSource &random, const RayTarget &target) {
  Point point, direction;
  latticePoint(random, target, point);
  wholeDirection(random, direction, 1 << random.integer(2, 10));
  return backedOff(point, direction, random.flip() ? 0.0f : std::ldexp(1.0f, random.integer(-10, 1)));
}

/// Through a corner or an edge of a voxel without coming into it: on one axis towards its inside, on another
/// away.
Ray touchRay(RandomSource &random, const RayTarget &target) {
  const Int3 cell = randomCell(random, target);
  Point point, direction;
  wholeDirection(random, direction);
  const int edge = random.integer(0, 3), out = random.integer(0, 2), in = (out + random.integer(1, 2)) % 3;
  for (int axis = 0; axis < 3; ++axis) {
    const bool high = random.flip();
    const float outward = high ? 1.0f : -1.0f, speed = std::abs(direction[axis]);
    point[axis] = static_cast<float>(cell[axis] + (high ? 1 : 0));
    if (axis == out || axis == in)
      direction[axis] = (axis == out ? outward : -outward) * std::max(speed, 1.0f);
    else if (axis == edge)
      point[axis] = static_cast<float>(cell[axis]) + 0.5f;
  }
  return backedOff(point, direction, static_cast<float>(random.integer(0, 16)) / 2);
}

} // namespace voxc::test
