// The mean colour of the triangles in a voxel.
#pragma once

#include "Mesh/ModelFrame.h"
#include "Mesh/Voxelize/NearestPoint.h"

#include <array>
#include <cstdint>

namespace voxc {

/// Triangles are averaged that have the same material and look about the same way.
struct SurfaceSide {
  std::uint32_t material = 0;
  glm::dvec3 normal{};
};

/// Of one voxel: the triangles of the surface that it shows, whose texels are finer than voxels, by their
/// areas in the voxel. Where a nearer triangle of another surface comes, all begins anew with that.
class VoxelMean {
public:
  /// Adds a triangle that has the colour `word` and so much area in the voxel, in squares of its sides.
  /// `isNearer`: none before it is as near. `current` is the voxel's word so far. Returns its word from now
  /// on.
  std::uint32_t add(const SurfaceSide &side, bool isNearer, double area, std::uint32_t word,
                    std::uint32_t current);

  /// What has come so far is not of the surface that the voxel shows.
  void clear() { *this = {}; }

private:
  std::array<float, 3> light_{}; ///< Linear, times area.
  float area_ = 0;
  std::uint32_t triangles_ = 0;
  std::uint32_t material_ = 0;
  std::array<float, 3> normal_{};
};

/// The area of the part of a triangle, whose corners are in voxels, that lies in the closed cube of a voxel.
double areaInVoxel(const std::array<glm::dvec3, 3> &triangle, const glm::dvec3 &low);

/// The same for one voxel after the other, and 1 where the triangle goes on beyond the voxel on all sides:
/// all of what could be there is.
class VoxelAreas {
public:
  VoxelAreas(const std::array<glm::dvec3, 3> &corners, const NearestPoints &triangle);

  /// `weights`: of the triangle's point that is nearest to the middle of the voxel at `low`.
  double in(const glm::dvec3 &low, const glm::dvec3 &weights) const;

private:
  std::array<glm::dvec3, 3> corners_;
  glm::dvec3 inner_; ///< Weights above these are far enough from the edges.
};

} // namespace voxc
