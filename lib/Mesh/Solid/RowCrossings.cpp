// Triangles against the rows of the cells that are asked for, which are sorted so that a triangle finds its
// own.
#include "Mesh/Solid/RowCrossings.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace voxc {

namespace {

__extension__ using Wide = __int128;

int signOf(Wide value) { return (value > 0) - (value < 0); }

/// Twice the area of the triangle a, b, p as it is seen along x. Without overflow: coordinates are below
/// 2^39.
Wide areaOf(const Point64 &a, const Point64 &b, const Point64 &p) {
  return Wide{b[1] - a[1]} * (p[2] - a[2]) - Wide{b[2] - a[2]} * (p[1] - a[1]);
}

/// On which side of the edge from a to b the row through p lies, -1 or 1; 0 if the edge is a point along x.
/// The row is moved by e in y and e^2 in z, so that it meets no edge.
int sideOf(const Point64 &a, const Point64 &b, const Point64 &p) {
  if (const Wide area = areaOf(a, b, p); area != 0)
    return signOf(area);
  return b[2] != a[2] ? (b[2] < a[2] ? 1 : -1) : signOf(b[1] - a[1]);
}

/// 1 or -1 if the row through p passes the triangle, by the way it turns; else 0.
int passed(const SnappedTriangle &triangle, const Point64 &p) {
  const auto &[a, b, c] = triangle.corners;
  const int side = sideOf(a, b, p);
  return side == sideOf(b, c, p) && side == sideOf(c, a, p) ? side : 0;
}

/// Is the triangle, which the row through p passes, passed at p or at a lower x?
bool isBelow(const SnappedTriangle &triangle, const Point64 &p) {
  const auto &[a, b, c] = triangle.corners;
  const Wide x = areaOf(a, b, c);
  const Wide y = Wide{b[2] - a[2]} * (c[0] - a[0]) - Wide{b[0] - a[0]} * (c[2] - a[2]);
  const Wide z = Wide{b[0] - a[0]} * (c[1] - a[1]) - Wide{b[1] - a[1]} * (c[0] - a[0]);
  // How far p lies above the plane along its normal: below 2^124.
  const Wide height = x * (p[0] - a[0]) + y * (p[1] - a[1]) + z * (p[2] - a[2]);
  return x > 0 ? height >= 0 : height <= 0;
}

std::pair<int, int> rowOf(Int3 cell) { return {cell.z, cell.y}; }

class Rows {
public:
  Rows(std::span<CellCrossings> cells, int bits) : cells_(cells), bits_(bits) {
    std::ranges::sort(cells_, {},
                      [](const CellCrossings &c) { return std::array{c.cell.z, c.cell.y, c.cell.x}; });
  }

  /// What a triangle counts for.
  struct Role {
    int way; ///< 0: not for winding and crossings; -1 if it is mirrored, else 1.
    bool isTwin;
  };

  void add(const SnappedTriangle &triangle, const Role &role) {
    const auto [firstZ, lastZ] = centresOf(triangle, 2);
    const auto [firstY, lastY] = centresOf(triangle, 1);
    if (firstY > lastY || firstZ > lastZ)
      return;
    auto at = from(firstZ, firstY);
    while (at != cells_.end() && at->cell.z <= lastZ) {
      if (at->cell.y < firstY)
        at = from(at->cell.z, firstY);
      else if (at->cell.y > lastY)
        at = from(at->cell.z + 1, firstY);
      else
        test(triangle, role, *at++);
    }
  }

private:
  /// The cells whose centres lie between the low and the high corner along an axis, cut to those there are.
  std::pair<int, int> centresOf(const SnappedTriangle &triangle, std::size_t axis) const {
    constexpr std::int64_t kMost = std::int64_t{1} << kMaxLog2Extent;
    const std::int64_t half = std::int64_t{1} << (bits_ - 1);
    const std::int64_t first = (triangle.low(axis) + half - 1) >> bits_;
    const std::int64_t last = (triangle.high(axis) - half) >> bits_;
    return {static_cast<int>(std::clamp<std::int64_t>(first, 0, kMost)),
            static_cast<int>(std::clamp<std::int64_t>(last, -1, kMost))};
  }

  std::span<CellCrossings>::iterator from(int z, int y) const {
    return std::ranges::lower_bound(cells_, std::pair(z, y), {},
                                    [](const CellCrossings &c) { return rowOf(c.cell); });
  }

  void test(const SnappedTriangle &triangle, const Role &role, CellCrossings &cell) const {
    Point64 centre;
    for (std::size_t axis = 0; axis < 3; ++axis)
      centre[axis] = (2 * std::int64_t{cell.cell[static_cast<int>(axis)]} + 1) << (bits_ - 1);
    if (triangle.low(0) > centre[0])
      return;
    const int way = passed(triangle, centre);
    if (way == 0 || !isBelow(triangle, centre))
      return;
    // Whoever leaves by a triangle sees it turn the other way.
    cell.winding -= way * role.way;
    cell.crossings += role.way != 0;
    cell.twins += role.isTwin;
  }

  std::span<CellCrossings> cells_;
  int bits_;
};

} // namespace

Expected<void> countCrossings(const TriangleScene &scene, const MeshModel &model,
                              ScratchArray<CellCrossings> &cells, WorkingMemory &memory,
                              const Progress &progress, const TriangleRoles &roles) {
  Rows rows(cells.span(), model.grid.bits());
  const auto add = [&](std::uint64_t number, const TriangleCursor &cursor) -> Expected<void> {
    const bool isTwin = number >= roles.twinCaps || (roles.twins && roles.twins->has(number));
    const int way = number >= roles.twinCaps ? 0 : cursor.isMirrored() ? -1 : 1;
    rows.add(model.snapped(cursor), {way, isTwin});
    return {};
  };
  return forEachTriangle(scene, model, nullptr, memory, progress, add);
}

} // namespace voxc
