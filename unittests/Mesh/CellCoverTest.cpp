// Cells that triangles touch, against clipping in rational arithmetic.
#include "ExactTriangle.h"
#include "TestLength.h"

#include "Mesh/Voxelize/CellCover.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <tuple>

namespace voxc {
namespace {

using Cell = std::tuple<int, int, int>;
using Cells = std::set<Cell>;

Cells covered(const SnappedTriangle &triangle, const CellShape &shape, const CellRange &within) {
  Cells cells;
  std::vector<CellMask> masks;
  coverCells(triangle, shape, within, masks);
  for (const CellMask &mask : masks)
    forEachCell(mask, [&](Int3 cell) {
      EXPECT_TRUE(cells.emplace(cell.x, cell.y, cell.z).second) << "a cell comes twice";
    });
  return cells;
}

ExactPoint exactly(const Point64 &point) {
  return {Rational(point[0]), Rational(point[1]), Rational(point[2])};
}

/// Does the triangle meet a box of this shape about the centre of the cell?
bool meets(const ExactTriangle &triangle, const CellShape &shape, Int3 cell) {
  for (std::size_t box = 0; box < shape.boxes; ++box) {
    Point64 low;
    Point64 high;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int64_t centre = (2 * std::int64_t{cell[static_cast<int>(axis)]} + 1)
                                  << (shape.log2Side - 1);
      low[axis] = centre - shape.halves[box][axis];
      high[axis] = centre + shape.halves[box][axis];
    }
    if (meetsExactly(triangle, exactly(low), exactly(high)))
      return true;
  }
  return false;
}

Cells bruteForce(const SnappedTriangle &triangle, const CellShape &shape, const CellRange &within) {
  const auto &[a, b, c] = triangle.corners;
  const ExactTriangle exact{exactly(a), exactly(b), exactly(c)};
  Cells cells;
  const CellRange box = cellsOf(triangle, shape.log2Side, within);
  for (Int3 cell = box.low; cell.z < box.high.z; ++cell.z)
    for (cell.y = box.low.y; cell.y < box.high.y; ++cell.y)
      for (cell.x = box.low.x; cell.x < box.high.x; ++cell.x)
        if (meets(exact, shape, cell))
          cells.emplace(cell.x, cell.y, cell.z);
  return cells;
}

void expectExact(const SnappedTriangle &triangle, int log2Side, const CellRange &within) {
  for (const CellShape &shape : {CellShape::cube(log2Side), CellShape::cross(log2Side)})
    ASSERT_EQ(covered(triangle, shape, within), bruteForce(triangle, shape, within))
        << "boxes " << shape.boxes << testing::PrintToString(triangle.corners);
}

/// Triangles whose coordinates are multiples of `step` from `low` up; some lie in a plane or on a line.
class RandomTriangles {
public:
  RandomTriangles(unsigned seed, std::int64_t low, std::int64_t step, std::uint64_t steps)
      : random_(seed), low_(low), step_(step), steps_(steps) {}

  SnappedTriangle next() {
    SnappedTriangle triangle;
    for (Point64 &corner : triangle.corners)
      for (std::int64_t &coordinate : corner)
        coordinate = low_ + step_ * static_cast<std::int64_t>(random_() % steps_);
    switch (random_() % 5) {
    case 0: // In a plane.
      for (Point64 &corner : triangle.corners)
        corner[1] = triangle.corners[0][1];
      break;
    case 1: // A segment, or a point.
      triangle.corners[2] = triangle.corners[random_() % 2];
      if (random_() % 4 == 0)
        triangle.corners[1] = triangle.corners[0];
      break;
    case 2: // Parallel to two axes.
      for (Point64 &corner : triangle.corners)
        corner[0] = corner[2] = triangle.corners[0][0];
      break;
    default:
      break;
    }
    return triangle;
  }

private:
  std::mt19937_64 random_;
  std::int64_t low_;
  std::int64_t step_;
  std::uint64_t steps_;
};

constexpr CellRange kSmall{{}, {9, 10, 8}};

TEST(CellCover, ExactOnALatticeThatMeetsFacesEdgesAndCorners) {
  RandomTriangles triangles(1, -32, 8, 24);
  for (int i = 0; i < test::rounds(80); ++i)
    expectExact(triangles.next(), 4, kSmall);
}

TEST(CellCover, ExactAnywhere) {
  RandomTriangles triangles(2, -40, 1, 240);
  for (int i = 0; i < test::rounds(60); ++i)
    expectExact(triangles.next(), 4, kSmall);
}

TEST(CellCover, ExactForTinyTriangles) {
  RandomTriangles triangles(3, 40, 1, 20);
  for (int i = 0; i < test::rounds(500); ++i)
    expectExact(triangles.next(), 4, kSmall);
}

/// A triangle through the cells near the origin that reaches `far` steps away.
SnappedTriangle hugeTriangle(std::mt19937_64 &random, std::int64_t far) {
  const auto within = [&](std::int64_t most) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * most + 1)) - most;
  };
  SnappedTriangle triangle;
  Point64 centre;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t a = within(far);
    const std::int64_t b = within(far);
    triangle.corners[0][axis] = a;
    triangle.corners[1][axis] = b;
    centre[axis] = 16 << 11; // Of the small range.
    triangle.corners[2][axis] = std::clamp(3 * centre[axis] - a - b + within(1 << 15), -far, far);
  }
  return triangle;
}

TEST(CellCover, ExactForTrianglesThatReachFarAway) {
  std::mt19937_64 random(4);
  std::size_t met = 0;
  for (int log2Far = 16; log2Far < SnapGrid::kLog2Reach; log2Far += 2)
    for (int i = 0; i < test::rounds(1); ++i) {
      const SnappedTriangle triangle = hugeTriangle(random, (std::int64_t{1} << log2Far) - 1);
      expectExact(triangle, 12, kSmall);
      met += covered(triangle, CellShape::cube(12), kSmall).empty() ? 0 : 1;
    }
  EXPECT_GT(met, 0u);
}

TEST(CellCover, LargeRangesAreTheirPartsPutTogether) {
  std::mt19937_64 random(5);
  for (int i = 0; i < test::rounds(12); ++i) {
    const int log2Far = 17 + i % 12;
    SnappedTriangle triangle = hugeTriangle(random, std::int64_t{1} << log2Far);
    const CellRange all{{3, 0, 1}, {77, 90, 70}};
    for (const CellShape &shape : {CellShape::cube(12), CellShape::cross(12)}) {
      Cells parts;
      for (Int3 low = all.low; low.z < all.high.z; low.z += 7)
        for (low.y = all.low.y; low.y < all.high.y; low.y += 7)
          for (low.x = all.low.x; low.x < all.high.x; low.x += 7) {
            CellRange part{low, low + Int3{7, 7, 7}};
            for (int axis = 0; axis < 3; ++axis)
              part.high[axis] = std::min(part.high[axis], all.high[axis]);
            parts.merge(covered(triangle, shape, part));
          }
      ASSERT_EQ(covered(triangle, shape, all), parts);
    }
  }
}

/// Cells by segments whose ends are drawn at random, by `coverSegments` and by clipping. Segments that a
/// triangle is parallel to are not looked at.
void expectSegments(const SnappedTriangle &triangle, int log2Side, std::mt19937_64 &random) {
  const auto &[a, b, c] = triangle.corners;
  const ExactTriangle exact{exactly(a), exactly(b), exactly(c)};
  SegmentEnds ends;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    const bool isUpright =
        Rational(b[u] - a[u]) * Rational(c[v] - a[v]) != Rational(b[v] - a[v]) * Rational(c[u] - a[u]);
    if (isUpright)
      ends.leftOut[axis] = static_cast<int>(random() % 3) - 1;
    ends.keptIn[axis] = static_cast<int>(random() % 9) - 1;
  }
  Cells expected;
  for (Int3 cell; cell.z < kSmall.high.z; ++cell.z)
    for (cell.y = 0; cell.y < kSmall.high.y; ++cell.y)
      for (cell.x = 0; cell.x < kSmall.high.x; ++cell.x)
        for (int axis = 0; axis < 3; ++axis) {
          const auto i = static_cast<std::size_t>(axis);
          if (ends.leftOut[i] == 0)
            continue;
          Point64 low;
          for (int k = 0; k < 3; ++k)
            low[static_cast<std::size_t>(k)] = (2 * std::int64_t{cell[k]} + 1) << (log2Side - 1);
          Point64 high = low;
          low[i] -= std::int64_t{1} << (log2Side - 1);
          high[i] += std::int64_t{1} << (log2Side - 1);
          const ExactPoint end = exactly(ends.leftOut[i] > 0 ? high : low);
          if (meetsExactly(exact, exactly(low), exactly(high)) &&
              (cell[axis] == ends.keptIn[i] || !meetsExactly(exact, end, end)))
            expected.emplace(cell.x, cell.y, cell.z);
        }
  Cells cells;
  std::vector<CellMask> masks;
  coverSegments(triangle, log2Side, ends, kSmall, masks);
  for (const CellMask &mask : masks)
    forEachCell(mask, [&](Int3 cell) { cells.emplace(cell.x, cell.y, cell.z); });
  ASSERT_EQ(cells, expected) << testing::PrintToString(triangle.corners);
}

TEST(CellCover, SegmentsWithoutAnEndAreExact) {
  std::mt19937_64 random(8);
  RandomTriangles lattice(9, -32, 8, 24);
  RandomTriangles anywhere(10, -40, 1, 240);
  for (int i = 0; i < test::rounds(20); ++i) {
    expectSegments(lattice.next(), 4, random);
    expectSegments(anywhere.next(), 4, random);
    expectSegments(hugeTriangle(random, (std::int64_t{1} << (16 + i % 22)) - 1), 12, random);
  }
}

TEST(CellCover, CrossesAreAmongCubes) {
  RandomTriangles triangles(6, -32, 4, 64);
  for (int i = 0; i < test::rounds(200); ++i) {
    const SnappedTriangle triangle = triangles.next();
    const Cells cubes = covered(triangle, CellShape::cube(4), kSmall);
    const Cells crosses = covered(triangle, CellShape::cross(4), kSmall);
    EXPECT_TRUE(std::includes(cubes.begin(), cubes.end(), crosses.begin(), crosses.end()));
  }
}

} // namespace
} // namespace voxc
