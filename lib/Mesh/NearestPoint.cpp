// Nearest point of a triangle: inside it where the foot of the perpendicular is, else on an edge.
#include "Mesh/NearestPoint.h"

#include <algorithm>
#include <optional>

namespace voxc {

namespace {

Double3 difference(const Double3 &a, const Double3 &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double dot(const Double3 &a, const Double3 &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

NearestPoint at(const std::array<Double3, 3> &triangle, const Double3 &weights, const Double3 &point) {
  double squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double offset = weights[0] * triangle[0][axis] + weights[1] * triangle[1][axis] +
                          weights[2] * triangle[2][axis] - point[axis];
    squared += offset * offset;
  }
  return {weights, squared};
}

/// Weights of the foot of the perpendicular, if it lies inside.
std::optional<Double3> footWeights(const std::array<Double3, 3> &triangle, const Double3 &point) {
  const Double3 u = difference(triangle[1], triangle[0]);
  const Double3 v = difference(triangle[2], triangle[0]);
  const Double3 p = difference(point, triangle[0]);
  const double uu = dot(u, u);
  const double uv = dot(u, v);
  const double vv = dot(v, v);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0))
    return std::nullopt;
  const double b = (vv * dot(u, p) - uv * dot(v, p)) / determinant;
  const double c = (uu * dot(v, p) - uv * dot(u, p)) / determinant;
  if (!(b >= 0 && c >= 0 && b + c <= 1))
    return std::nullopt;
  return Double3{1 - b - c, b, c};
}

/// Weights of the nearest point of the edge from vertex `from` to vertex `to`.
Double3 edgeWeights(const std::array<Double3, 3> &triangle, std::size_t from, std::size_t to,
                    const Double3 &point) {
  const Double3 edge = difference(triangle[to], triangle[from]);
  const double squared = dot(edge, edge);
  const double along = squared > 0 ? dot(edge, difference(point, triangle[from])) / squared : 0;
  Double3 weights{};
  weights[to] = std::clamp(along, 0.0, 1.0);
  weights[from] = 1 - weights[to];
  return weights;
}

} // namespace

NearestPoint nearestPoint(const std::array<Double3, 3> &triangle, const Double3 &point) {
  if (const auto weights = footWeights(triangle, point))
    return at(triangle, *weights, point);
  NearestPoint best = at(triangle, edgeWeights(triangle, 0, 1, point), point);
  for (const auto &weights : {edgeWeights(triangle, 1, 2, point), edgeWeights(triangle, 2, 0, point)})
    if (const NearestPoint other = at(triangle, weights, point); other.distanceSquared < best.distanceSquared)
      best = other;
  return best;
}

} // namespace voxc
