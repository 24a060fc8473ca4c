// Is a mesh closed, and which way does it face? Told by the edges of its triangles.
#pragma once

#include "Mesh/Solid/TriangleSet.h"
#include "Mesh/Voxelize/VoxelRule.h"
#include "voxc/Mesh/SolidMesh.h"

#include <memory>
#include <vector>

namespace voxc {

/// An edge at the rim of a hole.
struct RimEdge {
  std::array<Point64, 2> ends;        ///< Snapped; the first is the lower one.
  std::array<glm::dvec3, 2> points{}; ///< In model units.
  std::int64_t times = 0; ///< It is passed so much more often from the first to the second than back.
};

/// The best rule for a mesh, and its open edges unless that is `SolidRule::Winding`. Edges are those of the
/// snapped triangles, so that corners in one place are one corner, whatever their numbers. They are compared
/// by hashes of 64 bits. Triangles that are mirrored turn the other way.
struct EdgeBalance {
  SolidRule rule = SolidRule::Winding;
  OpenEdges open;
  std::vector<RimEdge> rims; ///< The open edges, in an order of no meaning.
  bool areRimsAll = true;    ///< False: there are too many for them to be worth keeping.

  /// Errors: interrupted, no memory.
  static Expected<EdgeBalance> of(const TriangleScene &scene, const MeshModel &model,
                                  const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

  /// Of some triangles alone, whichever way they turn: the rule is `Parity` if each edge is passed an even
  /// number of times. The rims are the other ones, each once.
  static Expected<EdgeBalance> ofEither(const TriangleSet &only, const TriangleScene &scene,
                                        const MeshModel &model, const std::shared_ptr<WorkingMemory> &memory,
                                        const Progress &progress);
};

/// How a mesh faces: known if its rule is `Winding` and it has a volume. Errors: interrupted, no memory.
Expected<Facing> facingOf(const TriangleScene &scene, const MeshModel &model,
                          const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

} // namespace voxc
