// How often rows of cells cross a mesh.
#pragma once

#include "Mesh/Voxelize/MeshModel.h"

#include <cstdint>
#include <memory>

namespace voxc {

/// A cell, and the triangles that the row from its centre towards -x passes.
struct CellCrossings {
  Int3 cell;
  std::int32_t winding =
      0; ///< Those it leaves by, whose corners turn left as seen from its end, less others.
  std::uint32_t crossings = 0; ///< All of them.
};

/// Counts the crossings of each of `cells`, whose order changes, going once through all triangles. A centre
/// that lies in a triangle may be on either side of it. Error: interrupted.
Expected<void> countCrossings(const TriangleScene &scene, const MeshModel &model,
                              ScratchArray<CellCrossings> &cells, WorkingMemory &memory,
                              const Progress &progress);

} // namespace voxc
