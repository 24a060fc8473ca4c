// Nearest point of a triangle: the foot of the perpendicular if it lies inside, else a point of an edge.
#include "Mesh/Voxelize/NearestPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxc {

namespace {

Double3 difference(const Double3 &a, const Double3 &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double dot(const Double3 &a, const Double3 &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Double3 cross(const Double3 &a, const Double3 &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Double3 scaled(const Double3 &a, double factor) { return {a[0] * factor, a[1] * factor, a[2] * factor}; }

/// A triangle whose sine at the first corner is below 2^-30 is too thin for weights to mean anything.
constexpr double kThinnestSquare = 0x1p-60;

} // namespace

NearestPoints::NearestPoints(const std::array<Double3, 3> &triangle) : corners_(triangle) {
  for (std::size_t from = 0; from < 3; ++from) {
    const Double3 direction = difference(triangle[(from + 1) % 3], triangle[from]);
    const double square = dot(direction, direction);
    edges_[from] = {direction, square > 0 ? 1 / square : 0};
  }
  const Double3 toSecond = edges_[0].direction;
  const Double3 toThird = difference(triangle[2], triangle[0]);
  const Double3 normal = cross(toSecond, toThird);
  const double square = dot(normal, normal);
  hasArea_ = square > kThinnestSquare * dot(toSecond, toSecond) * dot(toThird, toThird);
  if (!hasArea_)
    return;
  const double inverse = 1 / square;
  normal_ = scaled(normal, std::sqrt(inverse));
  gradients_ = {scaled(cross(toThird, normal), inverse), scaled(cross(normal, toSecond), inverse)};
}

NearestPoint NearestPoints::to(const Double3 &point) const {
  const std::array<Double3, 3> offsets{difference(point, corners_[0]), difference(point, corners_[1]),
                                       difference(point, corners_[2])};
  if (!hasArea_)
    return onEdges(offsets, {true, true, true});
  const double second = dot(offsets[0], gradients_[0]);
  const double third = dot(offsets[0], gradients_[1]);
  const double first = 1 - second - third;
  if (first >= 0 && second >= 0 && third >= 0) {
    const double distance = dot(offsets[0], normal_);
    return {{first, second, third}, distance * distance};
  }
  // The nearest point lies on an edge that the foot is beyond.
  return onEdges(offsets, {third < 0, first < 0, second < 0});
}

NearestPoint NearestPoints::onEdges(const std::array<Double3, 3> &offsets,
                                    const std::array<bool, 3> &candidates) const {
  double nearest = std::numeric_limits<double>::infinity();
  double along = 0;
  std::size_t best = 0;
  for (std::size_t from = 0; from < 3; ++from) {
    if (!candidates[from])
      continue;
    const Edge &edge = edges_[from];
    const double t = std::clamp(dot(edge.direction, offsets[from]) * edge.inverseSquare, 0.0, 1.0);
    const Double3 rest = difference(offsets[from], scaled(edge.direction, t));
    const double square = dot(rest, rest);
    if (square < nearest) {
      nearest = square;
      along = t;
      best = from;
    }
  }
  NearestPoint found{{}, nearest};
  found.weights[best] = 1 - along;
  found.weights[(best + 1) % 3] = along;
  return found;
}

} // namespace voxc
