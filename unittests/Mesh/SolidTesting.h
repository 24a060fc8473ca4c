// What tests of solids share: shapes in the unit cube, and which cells come out.
#pragma once

#include "SolidShapes.h"
#include "Source/SourceTesting.h"
#include "voxc/Mesh/SolidMesh.h"

#include <set>

namespace voxc::test {

inline constexpr std::uint32_t kFill = 0xff332211;
using Cells = std::set<std::uint64_t>; ///< Morton codes.

/// The unit cube, cut into so many voxels an axis.
inline VoxelizeOptions optionsAt(int resolution, Coverage coverage = Coverage::Conservative) {
  VoxelizeOptions options;
  options.resolution = resolution;
  options.bounds = {{0, 0, 0, 1, 1, 1}};
  options.coverage = coverage;
  return options;
}

inline Cells cellsOf(VoxelSource &source) {
  Cells cells;
  for (const auto &[code, word] : voxelsOf(source))
    cells.insert(code);
  return cells;
}

} // namespace voxc::test
