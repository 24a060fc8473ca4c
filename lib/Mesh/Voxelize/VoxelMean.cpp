// Sums of light by area, and triangles clipped by the six sides of a voxel.
#include "Mesh/Voxelize/VoxelMean.h"

#include "Support/Srgb.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace voxc {

namespace {

/// A convex polygon in a plane; each clip adds a corner at most.
struct ClippedTriangle {
  std::array<glm::dvec3, 12> corners;
  std::size_t count = 0;

  void add(const glm::dvec3 &corner) {
    if (count < corners.size())
      corners[count++] = corner;
  }
};

/// The part where `sign` times the coordinate is at most `sign` times the border.
ClippedTriangle clipped(const ClippedTriangle &polygon, int axis, double border, double sign) {
  ClippedTriangle inside;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const glm::dvec3 &from = polygon.corners[i];
    const glm::dvec3 &to = polygon.corners[(i + 1) % polygon.count];
    const double before = sign * (border - from[axis]);
    const double behind = sign * (border - to[axis]);
    if (before >= 0)
      inside.add(from);
    if ((before < 0) != (behind < 0))
      inside.add(from + (to - from) * (before / (before - behind)));
  }
  return inside;
}

} // namespace

double areaInVoxel(const std::array<glm::dvec3, 3> &triangle, const glm::dvec3 &low) {
  ClippedTriangle polygon;
  for (const glm::dvec3 &corner : triangle)
    polygon.add(corner);
  for (int axis = 0; axis < 3; ++axis) {
    const auto [least, greatest] = std::minmax({triangle[0][axis], triangle[1][axis], triangle[2][axis]});
    if (least < low[axis])
      polygon = clipped(polygon, axis, low[axis], -1);
    if (greatest > low[axis] + 1)
      polygon = clipped(polygon, axis, low[axis] + 1, 1);
  }
  glm::dvec3 sum(0);
  for (std::size_t i = 2; i < polygon.count; ++i)
    sum += glm::cross(polygon.corners[i - 1] - polygon.corners[0], polygon.corners[i] - polygon.corners[0]);
  return glm::length(sum) / 2;
}

VoxelAreas::VoxelAreas(const std::array<glm::dvec3, 3> &corners, const NearestPoints &triangle)
    : corners_(corners) {
  constexpr double kHalfDiagonal = 0.87; // Of a voxel.
  const auto &[second, third] = triangle.gradients();
  // A weight changes by the length of its gradient a voxel.
  inner_ = kHalfDiagonal * glm::dvec3(glm::length(second + third), glm::length(second), glm::length(third));
}

double VoxelAreas::in(const glm::dvec3 &low, const glm::dvec3 &weights) const {
  const bool isInner = weights[0] > inner_[0] && weights[1] > inner_[1] && weights[2] > inner_[2];
  return isInner ? 1 : areaInVoxel(corners_, low);
}

std::uint32_t VoxelMean::add(const SurfaceSide &side, bool isNearer, double area, std::uint32_t word,
                             std::uint32_t current) {
  const glm::dvec3 shown(normal_[0], normal_[1], normal_[2]);
  if (triangles_ == 0 || side.material != material_ || !(glm::dot(shown, side.normal) > 0)) {
    if (!isNearer)
      return current;
    *this = {};
  }
  if (isNearer) {
    material_ = side.material;
    for (int axis = 0; axis < 3; ++axis)
      normal_[static_cast<std::size_t>(axis)] = static_cast<float>(side.normal[axis]);
  }
  ++triangles_;
  area_ += static_cast<float>(area);
  for (std::size_t i = 0; i < light_.size(); ++i)
    light_[i] += static_cast<float>(kLinearLight[word >> 8 * i & 255] * area);
  const std::uint32_t shows = isNearer ? word : current;
  if (triangles_ == 1 || !(area_ > 0))
    return shows;
  std::uint32_t mean = shows & 0xff000000;
  for (std::size_t i = 0; i < light_.size(); ++i)
    mean |= srgbByte(static_cast<double>(light_[i]) / area_) << 8 * i;
  return mean;
}

} // namespace voxc
