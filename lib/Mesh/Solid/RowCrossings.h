// How often rows of cells cross a mesh.
#pragma once

#include "Mesh/Solid/TriangleSet.h"

#include <cstdint>
#include <memory>

namespace voxc {

/// A cell, and the triangles that the row from its centre towards -x passes.
struct CellCrossings {
  Int3 cell;
  std::int32_t winding =
      0; ///< Those it leaves by, whose corners turn left as seen from its end, less others.
  std::uint32_t crossings = 0; ///< All of them.
  std::uint32_t twins = 0;     ///< Those that `TriangleRoles` counts for themselves.
};

/// Which triangles count for what; by default all for winding and crossings.
struct TriangleRoles {
  const TriangleSet *twins = nullptr;         ///< They count as twins, too.
  std::uint64_t twinCaps = ~std::uint64_t{0}; ///< From this number on they count as twins alone.
};

/// Counts the crossings of each of `cells`, whose order changes, going once through all triangles. Of a
/// centre that lies in a triangle, the triangle is at a lower x. Error: interrupted.
Expected<void> countCrossings(const TriangleScene &scene, const MeshModel &model,
                              ScratchArray<CellCrossings> &cells, WorkingMemory &memory,
                              const Progress &progress, const TriangleRoles &roles = {});

} // namespace voxc
