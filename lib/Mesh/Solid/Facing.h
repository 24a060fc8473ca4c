// Which way a mesh faces, and how large it is.
#pragma once

#include "Mesh/Solid/TriangleSet.h"
#include "Mesh/Voxelize/VoxelRule.h"

#include <memory>

namespace voxc {

/// The area of a scene, or of some of its triangles, in squares of a voxel's side. Error: interrupted.
Expected<double> areaOf(const TriangleScene &scene, const MeshModel &model, const TriangleSet *only,
                        WorkingMemory &memory, const Progress &progress);

/// How a mesh faces: known if its triangles turn alike, it is closed but for small holes (`kMostHoles`), as
/// cracks beside corners on edges are, and it has a volume. Errors: interrupted, no memory.
Expected<Facing> facingOf(const TriangleScene &scene, const MeshModel &model,
                          const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

} // namespace voxc
