// Rays whose components are very small, very large, very far away, or all of it at once.
#include "Families.h"
#include "Points.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace voxc::test {

Ray tinyRay(RandomSource &random, const RayTarget &target) {
  Ray ray = random.flip() ? insideRay(random, target) : diagonalRay(random, target);
  const int common = random.flip() ? random.integer(0, 150) : 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int own = random.flip() ? random.integer(0, 150) : 0;
    ray.direction[axis] = std::ldexp(ray.direction[axis], -std::max(common, own));
    if (random.integer(0, 3) == 0)
      ray.origin[axis] = signedPower(random, -149, -20);
  }
  return ray;
}

/// Any ray whose direction, and so t, is scaled by up to 1e20 or 1e-20.
Ray scaledRay(RandomSource &random, const RayTarget &target) {
  constexpr float kScales[] = {1e20f, 1e-20f, 1e-10f, 1e10f};
  Ray ray = random.flip() ? cameraRay(random, target) : wholeRay(random, target);
  const float scale = kScales[random.integer(0, 3)];
  for (float &component : ray.direction)
    component *= scale;
  return ray;
}

Ray farRay(RandomSource &random, const RayTarget &target) {
  Point aim;
  random.flip() ? randomPoint(random, target, aim) : latticePoint(random, target, aim);
  const double distance = random.flip() ? random.real(1e4, 1e5) : random.real(1e5, 1e6);
  Point origin;
  for (int axis = 0; axis < 3; ++axis)
    origin[axis] = aim[axis] + static_cast<float>(distance * random.real(-1, 1));
  return between(origin, aim);
}

/// From ten thousand to a billion voxels away on one axis, so aimed on the two others that it comes through
/// the grid all the same; or on a diagonal from as far on every axis that moves.
Ray farthestRay(RandomSource &random, const RayTarget &target) {
  const float distance = static_cast<float>(scaledReal(random, 14, 30));
  Point aim, origin;
  random.flip() ? randomPoint(random, target, aim) : latticePoint(random, target, aim);
  randomPoint(random, target, origin, 1);
  const bool diagonal = random.integer(0, 3) == 0;
  const int along = random.integer(0, 2);
  for (int axis = 0; axis < 3; ++axis)
    if (axis == along || (diagonal && random.flip()))
      origin[axis] = aim[axis] + random.sign() * distance;
  return between(origin, aim);
}

/// A ray that is hard for another reason, from so far back on its own line: twice the grid's size, where its
/// numbers begin to be wrong by more than those of rays from near, up to 2^40 times. Of whole numbers nothing
/// is rounded on the way back, and what was a tie stays one.
Ray retreatRay(RandomSource &random, const RayTarget &target) {
  constexpr Ray (*kKinds[])(RandomSource &, const RayTarget &) = {
      cameraRay,  wholeRay,    diagonalRay, exactTieRay, brokenTieRay, nearTieRay,
      grazingRay, axisFaceRay, axisEdgeRay, touchRay,    cornerRay,    onBoundaryRay};
  Ray ray = kKinds[random.integer(0, std::size(kKinds) - 1)](random, target);
  const auto [x, y, z] = ray.direction;
  const float largest = std::max({std::abs(x), std::abs(y), std::abs(z)});
  const int longest = std::max({target.extent.x, target.extent.y, target.extent.z});
  if (!(largest > 0) || !std::isfinite(largest))
    return ray;
  // Most from where float32 has a fraction left; then a power of two, so that products are exact.
  const int edges = random.integer(0, 3) == 0 ? random.integer(1, 40) : random.integer(1, 14);
  const double moment = std::exp2(std::ilogb(longest) + edges - std::ilogb(largest));
  for (int axis = 0; axis < 3; ++axis)
    ray.origin[axis] = static_cast<float>(ray.origin[axis] - moment * ray.direction[axis]);
  return ray;
}

/// From just about 2^21, where a float32 has three bits behind the point.
Ray largeRay(RandomSource &random, const RayTarget &target) {
  Point aim, origin;
  latticePoint(random, target, aim);
  for (int axis = 0; axis < 3; ++axis) {
    const float sign = random.sign(), eighths = static_cast<float>(random.integer(-8, 8));
    origin[axis] = random.flip() ? sign * (0x1p21f + eighths / 8)
                                 : static_cast<float>(random.real(-1, 2) * target.extent[axis]);
  }
  return between(origin, aim);
}

/// Components whose exponents have nothing to do with each other.
Ray mixedRay(RandomSource &random, const RayTarget &target) {
  Point aim, origin;
  randomPoint(random, target, aim);
  for (int axis = 0; axis < 3; ++axis) {
    const float size = signedPower(random, -149, 30);
    origin[axis] = size * static_cast<float>(random.real(0.5, 1));
    if (random.integer(0, 2) == 0)
      origin[axis] = aim[axis];
  }
  Ray ray = between(origin, aim);
  for (float &component : ray.direction)
    if (random.integer(0, 3) == 0)
      component = signedPower(random, -149, 30);
  return ray;
}

/// Components up to the largest float32; half of the rays start at the same distance on every moving axis,
/// and so still meet the grid.
Ray hugeRay(RandomSource &random, const RayTarget &target) {
  Ray ray = random.flip() ? insideRay(random, target) : diagonalRay(random, target);
  const bool aimed = random.flip();
  const float power = std::ldexp(1.0f, random.integer(60, 127));
  const float size = power * static_cast<float>(random.real(0.5, 1));
  for (int axis = 0; axis < 3; ++axis) {
    ray.direction[axis] = random.integer(0, 3) == 0 ? 0.0f : random.sign() * size;
    if (aimed && ray.direction[axis] != 0)
      ray.origin[axis] = -ray.direction[axis];
    else if (!aimed && random.integer(0, 3) == 0)
      ray.origin[axis] = random.sign() * std::numeric_limits<float>::max();
  }
  return ray;
}

} // namespace voxc::test
