// Is a mesh closed? Told by the edges of its triangles.
#pragma once

#include "Mesh/Voxelize/MeshModel.h"
#include "voxc/Mesh/SolidMesh.h"

#include <memory>

namespace voxc {

/// The best rule for a mesh, and its open edges unless that is `SolidRule::Winding`. Edges are those of the
/// snapped triangles, so that corners in one place are one corner, whatever their numbers. They are compared
/// by hashes of 64 bits.
struct EdgeBalance {
  SolidRule rule = SolidRule::Winding;
  OpenEdges open;

  /// Errors: interrupted, no memory.
  static Expected<EdgeBalance> of(const TriangleScene &scene, const MeshModel &model,
                                  const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);
};

} // namespace voxc
