// Does a triangle touch a box? Decided by clipping in rational arithmetic: slow, and right.
#pragma once

#include "voxc/Support/Geometry.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <vector>

namespace voxc {

using Rational = boost::multiprecision::cpp_rational;
using ExactPoint = std::array<Rational, 3>;
using ExactTriangle = std::array<ExactPoint, 3>;

/// What remains of a convex polygon where sign * (coordinate - bound) >= 0.
inline std::vector<ExactPoint> clipPolygon(const std::vector<ExactPoint> &polygon, std::size_t axis, int sign,
                                           const Rational &bound) {
  std::vector<ExactPoint> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactPoint &a = polygon[i];
    const ExactPoint &b = polygon[(i + 1) % polygon.size()];
    const Rational insideA = sign * (a[axis] - bound);
    const Rational insideB = sign * (b[axis] - bound);
    if (insideA >= 0)
      kept.push_back(a);
    if (insideA * insideB < 0) {
      ExactPoint crossing;
      const Rational t = insideA / (insideA - insideB);
      for (std::size_t k = 0; k < 3; ++k)
        crossing[k] = a[k] + t * (b[k] - a[k]);
      kept.push_back(crossing);
    }
  }
  return kept;
}

/// True if the closed triangle and the closed box from `low` to `high` have a common point.
inline bool meetsExactly(const ExactTriangle &triangle, const ExactPoint &low, const ExactPoint &high) {
  std::vector<ExactPoint> polygon(triangle.begin(), triangle.end());
  for (std::size_t axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    polygon = clipPolygon(polygon, axis, 1, low[axis]);
    polygon = clipPolygon(polygon, axis, -1, high[axis]);
  }
  return !polygon.empty();
}

/// The same for a closed voxel, widened by `margin` on each side.
inline bool touchesExactly(const ExactTriangle &triangle, Int3 voxel, double margin) {
  ExactPoint low;
  ExactPoint high;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = voxel[static_cast<int>(axis)] - Rational(margin);
    high[axis] = voxel[static_cast<int>(axis)] + 1 + Rational(margin);
  }
  return meetsExactly(triangle, low, high);
}

} // namespace voxc
