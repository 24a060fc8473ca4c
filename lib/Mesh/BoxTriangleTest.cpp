// The separating axes of a triangle and a box: three of the box, the triangle's normal, nine of edge pairs.
#include "Mesh/BoxTriangleTest.h"

#include <algorithm>
#include <cmath>

namespace voxc {

namespace {

Double3 cross(const Double3 &a, const Double3 &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Double3 difference(const Double3 &a, const Double3 &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double dot(const Double3 &a, const Double3 &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

constexpr std::array<Double3, 3> kUnits{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

} // namespace

BoxTriangleTest::BoxTriangleTest(const std::array<Double3, 3> &triangle) : triangle_(triangle) {
  double largest = 0;
  for (const Double3 &vertex : triangle)
    for (double coordinate : vertex)
      largest = std::max(largest, std::abs(coordinate));
  // 2^-50 for the vertices (ModelFrame); a shadow is three products and two sums of 2^-53 each, made twice.
  error_ = (largest + 1) * 0x1p-48;

  for (const Double3 &unit : kUnits)
    addAxis(unit);
  const std::array<Double3, 3> edges{difference(triangle[1], triangle[0]),
                                     difference(triangle[2], triangle[1]),
                                     difference(triangle[0], triangle[2])};
  addAxis(cross(edges[0], edges[1]));
  for (const Double3 &edge : edges)
    for (const Double3 &unit : kUnits)
      addAxis(cross(edge, unit));
}

void BoxTriangleTest::addAxis(const Double3 &direction) {
  const Double3 absolute{std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2])};
  const std::array<double, 3> shadows{dot(direction, triangle_[0]), dot(direction, triangle_[1]),
                                      dot(direction, triangle_[2])};
  const auto [low, high] = std::minmax_element(shadows.begin(), shadows.end());
  const double slack = error_ * (absolute[0] + absolute[1] + absolute[2]);
  axes_[axisCount_++] = {direction, absolute, *low - slack, *high + slack};
}

bool BoxTriangleTest::touches(const VoxelBox &box) const {
  Double3 centre;
  Double3 half;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    centre[i] = 0.5 * (static_cast<double>(box.low[axis]) + box.high[axis]);
    half[i] = 0.5 * (static_cast<double>(box.high[axis]) - box.low[axis]);
  }
  return std::all_of(axes_.begin(), axes_.end(), [&](const Axis &axis) {
    const double shadow = dot(axis.direction, centre);
    const double reach = dot(axis.absolute, half);
    return shadow + reach >= axis.low && shadow - reach <= axis.high;
  });
}

} // namespace voxc
