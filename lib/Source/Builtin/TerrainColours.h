// What the terrain is made of: a colour for each of its voxels.
#pragma once

#include "Source/Builtin/TerrainShape.h"

#include <cstdint>

namespace voxc {

class TerrainColours {
public:
  explicit TerrainColours(const TerrainShape &shape);

  /// A voxel of the ground; its column's ground is at `ground` and falls by `drop` to the lowest neighbour.
  std::uint32_t ground(Int3 cell, int ground, int drop) const;
  /// A voxel of the water, `depth` voxels above the ground.
  std::uint32_t water(Int3 cell, int depth) const;
  std::uint32_t tree(Int3 cell, const Tree &tree) const;

private:
  std::uint32_t cover(Int3 cell, int drop) const;
  std::uint32_t stratum(Int3 cell) const;

  int side_;
  int waterLevel_;
  Noise patches_;
  Noise folds_;
};

} // namespace voxc
