// The separating axes of a triangle and boxes of one size, prepared for windows of 8x8x8 boxes at a time.
#pragma once

#include "Mesh/Voxelize/CellCover.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

namespace voxc {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

/// Largest side of the triangle's box.
inline std::int64_t sizeOf(const SnappedTriangle &triangle) {
  std::int64_t size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    size = std::max(size, triangle.high(axis) - triangle.low(axis));
  return size;
}

/// A triangle T and a box B with half sizes h have a point in common unless an axis separates them: one of
/// the box, the triangle's normal, or the product of an edge and an axis of the box. The latter nine are the
/// edges' normals in the three projections along an axis. There, only the side of an edge that looks away
/// from the triangle can separate, and both sides where the projection is a segment. The axes of the box
/// leave those cells that the triangle's own box reaches.
///
/// `Wide` holds all values: 64 bits while `fits`, else 128.
template <typename Wide> class Separation {
public:
  /// True if 64 bits are enough for windows of cells that the triangle's box touches.
  static bool fits(const SnappedTriangle &triangle, int log2Side) {
    const double size = static_cast<double>(sizeOf(triangle));
    // A window's cells reach no farther than this from the triangle.
    const double reach = size + 16 * static_cast<double>(std::int64_t{1} << log2Side);
    return 12 * size * size * reach < 0x1p62 && 4 * size * reach < 0x1p62;
  }

  Separation(const SnappedTriangle &triangle, const Point64 &half, int log2Side)
      : corner_(triangle.corners[0]), log2Side_(log2Side) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lows_[axis] = triangle.low(axis) - half[axis] - corner_[axis];
      highs_[axis] = triangle.high(axis) + half[axis] - corner_[axis];
    }
    for (std::size_t i = 0; i < kProjections.size(); ++i)
      project(triangle, half, i);
    addNormal(triangle, half);
  }

  /// Adds the cells that are touched to `mask`, in a window that begins at `mask.low` and has `size` cells.
  void cover(CellMask &mask, Int3 size) const {
    const Point64 centre = offsetOf(mask.low);
    const std::array<std::uint64_t, 3> reached{reachedCells(0, centre, size), reachedCells(1, centre, size),
                                               reachedCells(2, centre, size)};
    std::array<std::uint64_t, 3> shadows;
    for (std::size_t i = 0; i < kProjections.size(); ++i) {
      const auto [u, v] = kProjections[i];
      shadows[i] = rowsOf(reached[v]) & reached[u] * kFirstColumn;
      if (shadows[i] != 0)
        shadows[i] &= shadow(i, centre, size);
      if (shadows[i] == 0)
        return;
    }
    std::array<std::uint64_t, 8> slices{};
    for (int z = 0; z < size.z; ++z)
      slices[static_cast<std::size_t>(z)] =
          shadows[0] & rowsOf(shadows[1] >> 8 * z & 255) & (shadows[2] >> 8 * z & 255) * kFirstColumn;
    if (!cutToPlane(slices, centre, size))
      return;
    for (std::size_t z = 0; z < 8; ++z)
      mask.slices[z] |= slices[z];
  }

private:
  /// The two axes of each projection.
  static constexpr std::array<std::array<std::size_t, 2>, 3> kProjections{{{0, 1}, {1, 2}, {0, 2}}};
  static constexpr std::uint64_t kFirstColumn = 0x0101010101010101;

  /// a u + b v + c >= 0 for the centres of cells relative to `corner_`.
  struct HalfPlane {
    Wide a;
    Wide b;
    Wide c;
  };

  struct Projection {
    std::array<HalfPlane, 3> planes;
    std::size_t count = 0;
  };

  /// Each of eight bits y becomes the row of bits 8 y to 8 y + 7.
  static std::uint64_t rowsOf(std::uint64_t bits) {
    const std::uint64_t spread = bits * kFirstColumn & 0x8040201008040201;
    return ((spread + 0x7f * kFirstColumn) >> 7 & kFirstColumn) * 255;
  }

  static Wide absolute(Wide value) { return value < 0 ? -value : value; }

  void addEdge(std::size_t projection, Wide a, Wide b, Wide u, Wide v, const Point64 &half) {
    const auto [i, j] = kProjections[projection];
    const Wide reach = absolute(a) * half[i] + absolute(b) * half[j];
    Projection &to = projections_[projection];
    to.planes[to.count++] = {a, b, reach - a * u - b * v};
  }

  void project(const SnappedTriangle &triangle, const Point64 &half, std::size_t projection) {
    const auto [i, j] = kProjections[projection];
    std::array<Wide, 3> u;
    std::array<Wide, 3> v;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      u[corner] = triangle.corners[corner][i] - corner_[i];
      v[corner] = triangle.corners[corner][j] - corner_[j];
    }
    const Wide area = u[1] * v[2] - u[2] * v[1];
    if (area == 0)
      return addSegment(projection, u, v, half);
    const Wide sign = area > 0 ? 1 : -1;
    for (std::size_t from = 0; from < 3; ++from) {
      const std::size_t to = (from + 1) % 3;
      addEdge(projection, sign * (v[from] - v[to]), sign * (u[to] - u[from]), u[from], v[from], half);
    }
  }

  /// All corners lie on a line, which any edge with a length shows; if none has one, all lie in a point.
  void addSegment(std::size_t projection, const std::array<Wide, 3> &u, const std::array<Wide, 3> &v,
                  const Point64 &half) {
    for (std::size_t to = 1; to < 3; ++to)
      if (u[to] != 0 || v[to] != 0) {
        addEdge(projection, -v[to], u[to], 0, 0, half);
        return addEdge(projection, v[to], -u[to], 0, 0, half);
      }
  }

  void addNormal(const SnappedTriangle &triangle, const Point64 &half) {
    std::array<Wide, 3> u;
    std::array<Wide, 3> v;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      u[axis] = triangle.corners[1][axis] - corner_[axis];
      v[axis] = triangle.corners[2][axis] - corner_[axis];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t i = (axis + 1) % 3;
      const std::size_t j = (axis + 2) % 3;
      normal_[axis] = u[i] * v[j] - u[j] * v[i];
      thickness_ += absolute(normal_[axis]) * half[axis];
    }
  }

  /// The centre of a cell, relative to `corner_`.
  Point64 offsetOf(Int3 cell) const {
    Point64 offset;
    for (std::size_t axis = 0; axis < 3; ++axis)
      offset[axis] =
          ((2 * std::int64_t{cell[static_cast<int>(axis)]} + 1) << (log2Side_ - 1)) - corner_[axis];
    return offset;
  }

  /// Values that go from below 0 to above it within a window are no larger than their change over it, so they
  /// mostly fit 64 bits even where they are made of terms that do not.
  static bool isShort(Wide change) {
    if constexpr (sizeof(Wide) == 8)
      return true;
    else
      return change < Wide{1} << 61;
  }

  /// Along an axis, a bit for each cell that the triangle's box reaches.
  std::uint64_t reachedCells(std::size_t axis, const Point64 &centre, Int3 size) const {
    std::uint64_t bits = 0;
    std::int64_t at = centre[axis];
    for (int cell = 0; cell < size[static_cast<int>(axis)]; ++cell, at += std::int64_t{1} << log2Side_)
      bits |= static_cast<std::uint64_t>(at >= lows_[axis] && at <= highs_[axis]) << cell;
    return bits;
  }

  /// Cells of a projection that no edge separates: bit u + 8 v.
  std::uint64_t shadow(std::size_t projection, const Point64 &centre, Int3 size) const {
    const auto [i, j] = kProjections[projection];
    const Projection &edges = projections_[projection];
    std::uint64_t mask = ~std::uint64_t{0};
    for (std::size_t k = 0; k < edges.count && mask != 0; ++k) {
      const HalfPlane &edge = edges.planes[k];
      const Wide first = edge.a * centre[i] + edge.b * centre[j] + edge.c;
      mask &= halfPlaneMask(first, edge.a << log2Side_, edge.b << log2Side_, size[static_cast<int>(i)],
                            size[static_cast<int>(j)]);
    }
    return mask;
  }

  static std::uint64_t halfPlaneMask(Wide first, Wide du, Wide dv, int columns, int rows) {
    const Wide changeU = du * (columns - 1);
    const Wide changeV = dv * (rows - 1);
    const Wide zero = 0;
    if (first + std::min(changeU, zero) + std::min(changeV, zero) >= 0)
      return ~std::uint64_t{0};
    if (first + std::max(changeU, zero) + std::max(changeV, zero) < 0)
      return 0;
    if (isShort(8 * (absolute(du) + absolute(dv))))
      return bitsAtLeastZero(static_cast<std::int64_t>(first), static_cast<std::int64_t>(du),
                             static_cast<std::int64_t>(dv), rows);
    return bitsAtLeastZero(first, du, dv, rows);
  }

  template <typename T> static std::uint64_t bitsAtLeastZero(T first, T du, T dv, int rows) {
    std::uint64_t mask = 0;
    for (int row = 0; row < rows; ++row, first += dv) {
      T value = first;
      std::uint64_t bits = 0;
      for (int column = 0; column < 8; ++column, value += du)
        bits |= static_cast<std::uint64_t>(value >= 0) << column;
      mask |= bits << 8 * row;
    }
    return mask;
  }

  /// Takes away the cells that the triangle's plane passes by; false if none is left.
  bool cutToPlane(std::array<std::uint64_t, 8> &slices, const Point64 &centre, Int3 size) const {
    const Wide first = normal_[0] * centre[0] + normal_[1] * centre[1] + normal_[2] * centre[2] + thickness_;
    const Wide last = 2 * thickness_;
    std::array<Wide, 3> steps;
    Wide low = first;
    Wide high = first;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      steps[axis] = normal_[axis] << log2Side_;
      const Wide change = steps[axis] * (size[static_cast<int>(axis)] - 1);
      (change < 0 ? low : high) += change;
    }
    if (low > last || high < 0)
      return false;
    if (low >= 0 && high <= last)
      return true;
    if (isShort(8 * (absolute(steps[0]) + absolute(steps[1]) + absolute(steps[2])) + last))
      keepWithin<std::int64_t, std::uint64_t>(slices, first, last, steps, size);
    else
      keepWithin<Int128, Uint128>(slices, first, last, steps, size);
    return true;
  }

  /// Keeps the cells whose value lies in [0, last]; as unsigned numbers, negative ones are above any `last`.
  template <typename T, typename Unsigned>
  static void keepWithin(std::array<std::uint64_t, 8> &slices, Wide first, Wide last,
                         const std::array<Wide, 3> &steps, Int3 size) {
    const auto most = static_cast<Unsigned>(last);
    const auto stepX = static_cast<T>(steps[0]);
    const auto stepY = static_cast<T>(steps[1]);
    const auto stepZ = static_cast<T>(steps[2]);
    auto slice = static_cast<T>(first);
    for (int z = 0; z < size.z; ++z, slice += stepZ) {
      std::uint64_t &cells = slices[static_cast<std::size_t>(z)];
      T row = slice;
      std::uint64_t kept = 0;
      for (int y = 0; cells >> 8 * y != 0; ++y, row += stepY) {
        T value = row;
        std::uint64_t bits = 0;
        if ((cells >> 8 * y & 255) != 0)
          for (int x = 0; x < 8; ++x, value += stepX)
            bits |= static_cast<std::uint64_t>(static_cast<Unsigned>(value) <= most) << x;
        kept |= bits << 8 * y;
        if (y == 7)
          break;
      }
      cells &= kept;
    }
  }

  Point64 corner_; ///< What all is relative to.
  int log2Side_;
  Point64 lows_; ///< Between these, the centre of a box is close enough to the triangle's box.
  Point64 highs_;
  std::array<Projection, 3> projections_;
  std::array<Wide, 3> normal_{};
  Wide thickness_ = 0; ///< How far from the plane, in lengths of the normal, a box still touches it.
};

} // namespace voxc
