// Which voxels a triangle takes, by each rule.
#pragma once

#include "Mesh/Voxelize/CellCover.h"
#include "voxc/Mesh/MeshSource.h"

#include <cstdint>
#include <vector>

namespace voxc {

/// How the corners of the triangles of a closed mesh turn.
enum class Facing : std::uint8_t {
  Unknown,  ///< It is not closed, or its triangles face both ways.
  Outwards, ///< To the left, as seen from outside.
  Inwards,
};

/// What a rule asks of a triangle beside its corners.
struct TriangleKind {
  bool isMirrored = false; ///< The place of its instance makes it turn the other way.
  bool isThin = false;     ///< It is a line or a point, which every rule takes as the conservative one does.
};

/// A rule, of which only `Coverage::Inner` asks how the mesh faces and where the volume ends.
class VoxelRule {
public:
  /// `bits`: log2 of the steps a voxel. `Coverage::Centre` takes what the conservative rule does: which of
  /// that is inside is for `centreMesh` to say.
  VoxelRule(Coverage coverage, int bits, Facing facing, Int3 extent);

  /// Sets `masks` to the voxels of `within`.
  void cover(const SnappedTriangle &triangle, TriangleKind kind, const CellRange &within,
             std::vector<CellMask> &masks) const;

private:
  SegmentEnds endsOf(const SnappedTriangle &triangle, bool isMirrored) const;

  CellShape cube_, shape_;
  bool isInner_;
  Facing facing_;
  Int3 extent_;
};

} // namespace voxc
