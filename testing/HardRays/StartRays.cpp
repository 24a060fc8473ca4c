// Rays whose start is what is hard: on boundaries, in voxels, on the grid's faces; and those that go nowhere.
#include "Families.h"
#include "Points.h"

#include <cmath>
#include <limits>

namespace voxc::test {

namespace {

/// Small whole numbers, or anything; zeros of both signs among them.
void anyDirection(RandomSource &random, Point &direction) {
  wholeDirection(random, direction);
  if (random.flip())
    for (float &component : direction)
      component *= static_cast<float>(random.real(0, 1));
}

} // namespace

/// From a face, an edge or a corner of a cell, exactly or an ulp beside it.
Ray onBoundaryRay(RandomSource &random, const RayTarget &target) {
  const Int3 cell = randomCell(random, target);
  Ray ray{};
  anyDirection(random, ray.direction);
  const int whole = random.integer(0, 2);
  for (int axis = 0; axis < 3; ++axis) {
    const bool onLattice = axis == whole || random.flip();
    const double offset = onLattice ? random.integer(0, 1) : random.real(0, 1);
    ray.origin[axis] = static_cast<float>(cell[axis] + offset);
    if (onLattice && random.integer(0, 3) == 0)
      ray.origin[axis] = nudged(random, ray.origin[axis]);
  }
  return ray;
}

/// From a voxel's middle or from just inside its walls.
Ray solidRay(RandomSource &random, const RayTarget &target) {
  constexpr double kPlaces[] = {0, 0x1p-30, 0.5, 1 - 0x1p-24};
  const Int3 cell = randomCell(random, target);
  Ray ray{};
  anyDirection(random, ray.direction);
  for (int axis = 0; axis < 3; ++axis)
    ray.origin[axis] = static_cast<float>(cell[axis] + kPlaces[random.integer(0, 3)]);
  return ray;
}

/// From a point exactly on one of the grid's six faces, or an ulp beside it: inward, outward or along it.
Ray farFaceRay(RandomSource &random, const RayTarget &target) {
  Ray ray{};
  random.flip() ? latticePoint(random, target, ray.origin) : randomPoint(random, target, ray.origin);
  anyDirection(random, ray.direction);
  const int axis = random.integer(0, 2);
  ray.origin[axis] = random.flip() ? static_cast<float>(target.extent[axis]) : 0.0f * random.sign();
  if (random.integer(0, 3) == 0)
    ray.origin[axis] = nudged(random, ray.origin[axis]);
  return ray;
}

/// With zeros of both signs in origin and direction.
Ray signedZeroRay(RandomSource &random, const RayTarget &target) {
  Ray ray = onBoundaryRay(random, target);
  const int zero = random.integer(0, 2);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == zero || random.flip())
      ray.origin[axis] = 0.0f * random.sign();
    if (axis != zero && random.flip())
      ray.direction[axis] = 0.0f * random.sign();
  }
  return ray;
}

Ray stillRay(RandomSource &random, const RayTarget &target) {
  Ray ray = random.flip() ? outsideRay(random, target) : insideRay(random, target);
  for (float &component : ray.direction)
    component = 0.0f * random.sign();
  return ray;
}

Ray notFiniteRay(RandomSource &random, const RayTarget &target) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kBad[] = {kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()};
  Ray ray = insideRay(random, target);
  Point &half = random.flip() ? ray.origin : ray.direction;
  half[random.integer(0, 2)] = kBad[random.integer(0, 2)];
  return ray;
}

} // namespace voxc::test
