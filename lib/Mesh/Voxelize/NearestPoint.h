// The point of a triangle that is nearest to another point.
#pragma once

#include "Mesh/ModelFrame.h"

#include <array>
#include <cstdint>

namespace voxc {

/// A point of a triangle by its weights at the three corners, and how far away it is.
struct NearestPoint {
  glm::dvec3 weights;
  double distanceSquared;
};

/// Finds points of a closed triangle, which may be a segment or a point.
class NearestPoints {
public:
  explicit NearestPoints(const std::array<glm::dvec3, 3> &triangle);

  /// The point nearest to `point`.
  NearestPoint to(const glm::dvec3 &point) const;

  /// How the weights of the second and third corner change along space; 0 where the triangle is too thin.
  const std::array<glm::dvec3, 2> &gradients() const { return gradients_; }

  /// Of length 1, or 0 where the triangle is too thin.
  const glm::dvec3 &normal() const { return normal_; }

private:
  /// From one corner to the next.
  struct Edge {
    glm::dvec3 direction;
    double inverseSquare; ///< 1 over the square of the length; 0 without one.
  };

  /// The nearest point on those edges that may have it; `offsets` lead from the corners to the point.
  NearestPoint onEdges(const std::array<glm::dvec3, 3> &offsets, const std::array<bool, 3> &candidates) const;

  std::array<glm::dvec3, 3> corners_;
  std::array<Edge, 3> edges_;
  glm::dvec3 normal_{};                   ///< Of length 1, or 0 without an area.
  std::array<glm::dvec3, 2> gradients_{}; ///< Of the weights of the second and third corner.
  bool hasArea_ = false;
};

/// A squared distance in voxels as it is compared: in steps of 2^-30, so that rounding does not decide
/// between triangles that meet.
inline std::uint32_t comparedDistance(double squared) {
  constexpr double kMost = 0x1p32 - 2;
  const double steps = squared * 0x1p30 + 0.5;
  return static_cast<std::uint32_t>(steps < kMost ? steps : kMost);
}

} // namespace voxc
