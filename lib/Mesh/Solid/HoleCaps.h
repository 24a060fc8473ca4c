// Triangles that close the holes of a mesh.
#pragma once

#include "Mesh/Solid/EdgeBalance.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// Fans from the middle of each rim: with them, each edge is passed as often one way as the other.
struct HoleCaps {
  std::vector<std::array<double, 3>> corners; ///< Three a triangle, in model units.
  std::uint64_t holes = 0;                    ///< Loops of their rims.
  double area = 0;                            ///< Of all fans, in squares of a voxel's side.

  /// May they close a mesh of this area?
  bool isSmall(double meshArea) const { return area <= kMostHoles * meshArea; }

  /// Closes all `rims`; or, if `isEither`, those that are passed an odd number of times, whichever way. If
  /// they make no loops, or 2^20 triangles or more, there are no fans, and the area is infinite.
  static HoleCaps of(std::span<const RimEdge> rims, bool isEither, const MeshModel &model);
};

} // namespace voxc
