// The rules as boxes about a voxel's centre, and the side on which a voxel takes a face between two.
#include "Mesh/Voxelize/VoxelRule.h"

#include <array>

namespace voxc {

namespace {

__extension__ using Wide = __int128;
using Signs = std::array<int, 3>;

int signOf(Wide value) { return (value > 0) - (value < 0); }

/// The signs of what stands upright on two edges.
Signs normalOf(const SnappedTriangle &triangle) {
  const auto &[a, b, c] = triangle.corners;
  Signs signs{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    signs[axis] = signOf(Wide{b[u] - a[u]} * (c[v] - a[v]) - Wide{b[v] - a[v]} * (c[u] - a[u]));
  }
  return signs;
}

/// Do all corners lie on one line along the axis, but not in one point?
bool runsAlong(const SnappedTriangle &triangle, std::size_t axis) {
  const auto isFlat = [&](std::size_t i) { return triangle.low(i) == triangle.high(i); };
  return !isFlat(axis) && isFlat((axis + 1) % 3) && isFlat((axis + 2) % 3);
}

} // namespace

VoxelRule::VoxelRule(Coverage coverage, int bits, Facing facing, Int3 extent)
    : cube_(CellShape::cube(bits)), shape_(coverage == Coverage::Thin ? CellShape::cross(bits) : cube_),
      isInner_(coverage == Coverage::Inner), facing_(facing), extent_(extent) {}

void VoxelRule::cover(const SnappedTriangle &triangle, TriangleKind kind, const CellRange &within,
                      std::vector<CellMask> &masks) const {
  if (kind.isThin)
    coverCells(triangle, cube_, within, masks);
  else if (isInner_)
    coverSegments(triangle, shape_.log2Side, endsOf(triangle, kind.isMirrored), within, masks);
  else
    coverCells(triangle, shape_, within, masks);
}

SegmentEnds VoxelRule::endsOf(const SnappedTriangle &triangle, bool isMirrored) const {
  const Signs normal = normalOf(triangle);
  const bool isThin = normal == Signs{};
  SegmentEnds ends;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (isThin ? runsAlong(triangle, axis) : normal[axis] == 0)
      continue;
    if (isThin || facing_ == Facing::Unknown) {
      ends.leftOut[axis] = 1;
      // Nothing that lies on the far face of the volume is lost.
      ends.keptIn[axis] = extent_[static_cast<int>(axis)] - 1;
      continue;
    }
    // The voxel on the outer side leaves out its end there: the low one where the way out is up.
    const int outwards = (facing_ == Facing::Outwards) != isMirrored ? normal[axis] : -normal[axis];
    ends.leftOut[axis] = -outwards;
  }
  return ends;
}

} // namespace voxc
