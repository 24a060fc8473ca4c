// A mesh made ready to be asked what is inside: closed, if there is a way.
#pragma once

#include "Mesh/Solid/EdgeBalance.h"
#include "Mesh/Solid/RowCrossings.h"

#include <memory>

namespace voxc {

/// The triangles of a scene, those that close its holes, and by which of them inside is told.
struct ClosedMesh {
  std::shared_ptr<const TriangleScene> scene; ///< Without colours; caps are its last parts.
  MeshModel model;
  SolidRule rule = SolidRule::Enclosure; ///< Of all triangles but the twins' caps.
  bool hasTwins = false; ///< Those of `twins` are closed for themselves: inside them counts, too.
  TriangleSet twins;
  std::uint64_t caps = 0;     ///< The number of the first triangle that closes a hole of all triangles,
  std::uint64_t twinCaps = 0; ///< and of the first one that closes a hole of twins.
  std::uint64_t holes = 0;
  double holeShare = 0; ///< Of the area.
  OpenEdges open;

  /// Errors: interrupted, no memory.
  static Expected<ClosedMesh> of(const TriangleScene &scene, const MeshModel &model,
                                 const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

  bool isClosed() const { return rule != SolidRule::Enclosure || hasTwins; }
  bool isInside(const CellCrossings &cell) const {
    return (rule == SolidRule::Winding && cell.winding != 0) ||
           (rule == SolidRule::Parity && cell.crossings % 2 != 0) || (hasTwins && cell.twins % 2 != 0);
  }
  /// For `countCrossings`.
  TriangleRoles roles() const { return {&twins, twinCaps}; }
};

} // namespace voxc
