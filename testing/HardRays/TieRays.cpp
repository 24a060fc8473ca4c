// Rays on which boundaries of several axes are crossed at almost, or exactly, the same large t.
#include "Families.h"
#include "Points.h"

#include <algorithm>
#include <cmath>

namespace voxc::test {

/// Past a lattice edge or corner, so closely that the products that decide agree in 40 bits and more: the
/// origin lies next to 0, where float32 is fine, and the lattice point far from it.
Ray nearTieRay(RandomSource &random, const RayTarget &target) {
  Ray ray{};
  const double t = scaledReal(random, 0, 20);
  for (int axis = 0; axis < 3; ++axis) {
    const int face = random.integer(target.extent[axis] / 2, target.extent[axis]);
    ray.direction[axis] = static_cast<float>(face / t);
    ray.origin[axis] = nudged(random, static_cast<float>(face - t * ray.direction[axis]));
  }
  if (random.integer(0, 3) == 0) // Two axes alone.
    ray.origin[random.integer(0, 2)] = static_cast<float>(random.real(0, 1));
  return ray;
}

/// The same from anywhere: towards a lattice point, along components of 24 bits each, as far back as float32
/// permits.
Ray nearLatticeRay(RandomSource &random, const RayTarget &target) {
  Point point, direction;
  latticePoint(random, target, point);
  for (float &component : direction)
    component = static_cast<float>(random.real(-1, 1));
  const int extent = target.extent[random.integer(0, 2)];
  Ray ray = backedOff(point, direction, static_cast<float>(random.real(0, 4) * extent));
  for (float &component : ray.origin)
    component = nudged(random, component);
  return ray;
}

/// To a lattice point exactly, at a t that is no whole number, along components without a common factor. The
/// bits are few enough for the origin to be a float32.
Ray exactTieRay(RandomSource &random, const RayTarget &target) {
  Point point, direction;
  latticePoint(random, target, point);
  wholeDirection(random, direction, 255);
  const int odd = 2 * random.integer(0, 127) + 1;
  const float steps = std::ldexp(static_cast<float>(odd), -random.integer(3, 8));
  Ray ray = backedOff(point, direction, steps);
  const float scale = std::ldexp(1.0f, random.integer(-30, 30));
  for (float &component : ray.direction)
    component *= scale;
  return ray;
}

/// The same with one component off by an ulp, so that what tied does not.
Ray brokenTieRay(RandomSource &random, const RayTarget &target) {
  Ray ray = exactTieRay(random, target);
  const int axis = random.integer(0, 2);
  float &component = random.flip() ? ray.origin[axis] : ray.direction[axis];
  component = nudged(random, component);
  return ray;
}

} // namespace voxc::test
