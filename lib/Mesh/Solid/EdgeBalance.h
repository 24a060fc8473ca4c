// Is a mesh closed? Told by the edges of its triangles.
#pragma once

#include "Mesh/Solid/TriangleSet.h"
#include "voxc/Mesh/SolidMesh.h"

#include <memory>
#include <vector>

namespace voxc {

/// An edge at the rim of a hole.
struct RimEdge {
  std::array<Point64, 2> ends;        ///< Snapped; the first is the lower one.
  std::array<glm::dvec3, 2> points{}; ///< In model units.
  std::int64_t times = 0;  ///< It is passed so much more often from the first to the second than back.
  std::uint64_t place = 0; ///< In the order of triangles.
};

/// The best rule for a mesh, and its open edges unless that is `SolidRule::Winding`. Where they are few
/// enough to be kept, edges that lie on each other even out, too, though one is parted by a corner and the
/// other is not. Edges are those of the snapped triangles, so that corners in one place are one corner,
/// whatever their numbers. They are compared by hashes of 64 bits. Triangles that are mirrored turn the other
/// way.
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

} // namespace voxc
