// Conservative voxelization: every voxel that a closed triangle touches.
#pragma once

#include "voxc/Mesh/TriangleMesh.h"
#include "voxc/Source/VoxelSource.h"

#include <array>
#include <memory>
#include <optional>

namespace voxc {

// Until its users take the one of MeshSource.h.
inline namespace replaced {

struct VoxelizeOptions {
  int resolution = 512;                        ///< Voxels on the longest axis of the bounds; 0: what fits.
  Int3 maxExtent{1 << 21, 1 << 21, 1 << 21};   ///< Error if the bounds need more than this on an axis.
  std::optional<std::array<double, 6>> bounds; ///< Crops, before the turn; default: the triangles' box.
  bool zUp = false;                            ///< Turns +z to +y (a rotation about x).
  Progress progress;
};

} // namespace replaced

/// Voxelizes a mesh. The low corner of the bounds lies at (0,0,0). A voxel takes the colour of the triangle
/// nearest to its centre, then of the lowest index, at the point nearest to the centre; where the material's
/// texture has alpha below one half, the triangle leaves no voxel. The overlap test is the separating axis
/// theorem in doubles, widened by its rounding error: conservative.
Expected<std::unique_ptr<VoxelSource>> voxelize(const TriangleMesh &mesh, const VoxelizeOptions &options);

} // namespace voxc
