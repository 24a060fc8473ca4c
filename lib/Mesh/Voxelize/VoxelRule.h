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

/// A rule, of which only `Coverage::Inner` asks how the mesh faces and where the volume ends.
class VoxelRule {
public:
  /// `bits`: log2 of the steps a voxel. `Coverage::Centre` takes what the conservative rule does: which of
  /// that is inside is for `centreMesh` to say.
  VoxelRule(Coverage coverage, int bits, Facing facing, Int3 extent);

  /// Sets `masks` to the voxels of `within`. A triangle is mirrored if the place of its instance makes it
  /// turn the other way.
  void cover(const SnappedTriangle &triangle, bool isMirrored, const CellRange &within,
             std::vector<CellMask> &masks) const;

private:
  SegmentEnds endsOf(const SnappedTriangle &triangle, bool isMirrored) const;

  CellShape shape_;
  bool isInner_;
  Facing facing_;
  Int3 extent_;
};

} // namespace voxc
