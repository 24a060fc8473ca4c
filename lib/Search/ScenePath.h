// The cubes, from the root of a scene's graph down, that lead to a voxel.
#pragma once

#include "RayPosition.h"

#include "voxc/Search/SceneDag.h"

#include <array>
#include <cstdint>

namespace voxc {

/// Keeps what it found of the last voxel, as neighbours share most of it.
class ScenePath {
public:
  /// Of a volume of 2^root voxels a side at the low corner of the scene.
  ScenePath(const SceneDag &dag, int root) : dag_(dag), root_(root), found_(root) {}

  /// The height of the empty cube around a voxel; -1 if the voxel is there.
  int find(Int3 voxel);

  /// The number, in the graph, of the cube of 2^height voxels a side around the voxel that was found, height
  /// above that of the empty cube.
  std::size_t number(int height) const { return numbers_[static_cast<std::size_t>(height)]; }

  /// True if the 4^3 cells of 2^bottom voxels a side around the voxel that was found have nothing where a ray
  /// of this octant may still come to from it. `byGroups`: of the groups of 2^3 cells that it is not in, it
  /// is told no more than whether they have something.
  bool hasNothingAhead(int bottom, unsigned octant, bool byGroups) const;

  const SceneDag &dag() const { return dag_; }

private:
  const SceneDag &dag_;
  int root_;
  int found_; ///< The last answer; before the first, the root is all that is known.
  Int3 last_{};
  std::array<std::uint32_t, 32> numbers_{};
};

} // namespace voxc
