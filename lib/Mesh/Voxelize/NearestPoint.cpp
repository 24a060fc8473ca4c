// Nearest point of a triangle: the foot of the perpendicular if it lies inside, else a point of an edge.
#include "Mesh/Voxelize/NearestPoint.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace voxc {

namespace {

/// A triangle whose sine at the first corner is below 2^-30 is too thin for weights to mean anything.
constexpr double kThinnestSquare = 0x1p-60;

} // namespace

NearestPoints::NearestPoints(const std::array<glm::dvec3, 3> &triangle) : corners_(triangle) {
  for (std::size_t from = 0; from < 3; ++from) {
    const glm::dvec3 direction = triangle[(from + 1) % 3] - triangle[from];
    const double square = glm::dot(direction, direction);
    edges_[from] = {direction, square > 0 ? 1 / square : 0};
  }
  const glm::dvec3 toSecond = edges_[0].direction;
  const glm::dvec3 toThird = triangle[2] - triangle[0];
  const glm::dvec3 normal = glm::cross(toSecond, toThird);
  const double square = glm::dot(normal, normal);
  hasArea_ = square > kThinnestSquare * glm::dot(toSecond, toSecond) * glm::dot(toThird, toThird);
  if (!hasArea_)
    return;
  const double inverse = 1 / square;
  normal_ = normal * std::sqrt(inverse);
  gradients_ = {glm::cross(toThird, normal) * inverse, glm::cross(normal, toSecond) * inverse};
}

NearestPoint NearestPoints::to(const glm::dvec3 &point) const {
  const std::array<glm::dvec3, 3> offsets{point - corners_[0], point - corners_[1], point - corners_[2]};
  if (!hasArea_)
    return onEdges(offsets, {true, true, true});
  const double second = glm::dot(offsets[0], gradients_[0]);
  const double third = glm::dot(offsets[0], gradients_[1]);
  const double first = 1 - second - third;
  if (first >= 0 && second >= 0 && third >= 0) {
    const double distance = glm::dot(offsets[0], normal_);
    return {{first, second, third}, distance * distance};
  }
  // The nearest point lies on an edge that the foot is beyond.
  return onEdges(offsets, {third < 0, first < 0, second < 0});
}

NearestPoint NearestPoints::onEdges(const std::array<glm::dvec3, 3> &offsets,
                                    const std::array<bool, 3> &candidates) const {
  double nearest = std::numeric_limits<double>::infinity();
  double along = 0;
  int best = 0;
  for (std::size_t from = 0; from < 3; ++from) {
    if (!candidates[from])
      continue;
    const Edge &edge = edges_[from];
    const double t = std::clamp(glm::dot(edge.direction, offsets[from]) * edge.inverseSquare, 0.0, 1.0);
    const glm::dvec3 rest = offsets[from] - edge.direction * t;
    const double square = glm::dot(rest, rest);
    if (square < nearest) {
      nearest = square;
      along = t;
      best = static_cast<int>(from);
    }
  }
  NearestPoint found{glm::dvec3(0), nearest};
  found.weights[best] = 1 - along;
  found.weights[(best + 1) % 3] = along;
  return found;
}

} // namespace voxc
