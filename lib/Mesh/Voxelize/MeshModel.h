// A checked scene with its place in voxel space: what every way to voxelize it starts from.
#pragma once

#include "Mesh/Voxelize/SnapGrid.h"
#include "Mesh/Voxelize/TriangleCursor.h"
#include "voxc/Mesh/MeshSource.h"

namespace voxc {

struct MeshModel {
  TriangleNumbers numbers;
  SnapGrid grid;

  /// Checks the scene and fits it into voxels. `memory` may be null. Errors: those of `makeMeshSource`.
  static Expected<MeshModel> open(const TriangleScene &scene, const VoxelizeOptions &options,
                                  WorkingMemory *memory);

  Int3 extent() const { return grid.frame().extent(); }

  /// The triangle at which `cursor` stands.
  SnappedTriangle snapped(const std::array<glm::dvec3, 3> &corners) const;
  SnappedTriangle snapped(const TriangleCursor &cursor) const { return snapped(cursor.corners()); }

  /// The corners of a snapped triangle in voxels, without rounding.
  std::array<glm::dvec3, 3> inVoxels(const SnappedTriangle &triangle) const;
};

} // namespace voxc
