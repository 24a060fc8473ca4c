// Which cells of a grid a triangle touches, decided in integers.
#pragma once

#include "Mesh/Voxelize/SnapGrid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace voxc {

/// Cells [low, high) on each axis.
struct CellRange {
  Int3 low;
  Int3 high;

  bool empty() const { return low.x >= high.x || low.y >= high.y || low.z >= high.z; }
};

/// A grid of cells that are cubes of 2^log2Side steps, and the closed boxes about each cell's centre of which
/// one must be touched for the cell to be.
struct CellShape {
  int log2Side = 0;
  std::array<Point64, 3> halves{}; ///< Half the size of each box.
  std::size_t boxes = 1;

  /// The cell itself.
  static CellShape cube(int log2Side);
  /// The three segments through the centre that join opposite faces.
  static CellShape cross(int log2Side);
};

/// Of the three segments through a cell's centre, which ends do not belong to them.
struct SegmentEnds {
  std::array<int, 3> leftOut{}; ///< 1: the high end, -1: the low one, 0: the segment is not looked at.
  std::array<int, 3> keptIn{-1, -1, -1}; ///< The cells with this coordinate have both ends all the same.
};

/// Touched cells among 8x8x8: bit x + 8 y of slice z is the cell low + (x, y, z).
struct CellMask {
  Int3 low;
  std::array<std::uint64_t, 8> slices{};
};

/// Calls `visit(cell)` for each cell of a mask.
template <typename Visit> void forEachCell(const CellMask &mask, Visit visit) {
  for (int z = 0; z < 8; ++z)
    for (std::uint64_t bits = mask.slices[static_cast<std::size_t>(z)]; bits != 0; bits &= bits - 1) {
      const int bit = __builtin_ctzll(bits);
      visit(mask.low + Int3{bit & 7, bit >> 3, z});
    }
}

/// The cells that the box around a triangle touches.
CellRange cellsOf(const SnappedTriangle &triangle, int log2Side, const CellRange &within);

/// Sets `masks` to the cells of `within` that the closed triangle touches; none lies in two masks, and a mask
/// may be empty. Exact also where the triangle or a box is flat, a segment or a point.
void coverCells(const SnappedTriangle &triangle, const CellShape &shape, const CellRange &within,
                std::vector<CellMask> &masks);

/// Sets `masks` to the cells of which the triangle meets a segment elsewhere than in an end that is left out.
/// Segments that are looked at must meet its line or plane in one point at most.
void coverSegments(const SnappedTriangle &triangle, int log2Side, const SegmentEnds &ends,
                   const CellRange &within, std::vector<CellMask> &masks);

} // namespace voxc
