// Windows of 8x8x8 cells over a triangle's box; large boxes are searched by cells eight times as large.
#include "Mesh/Voxelize/CellCover.h"

#include "Mesh/Voxelize/Separation.h"

#include <algorithm>
#include <utility>

namespace voxc {

namespace {

/// With more windows than this, it pays to find out which of them the triangle touches.
constexpr std::int64_t kFewWindows = 12;

CellRange intersection(const CellRange &a, const CellRange &b) {
  CellRange range;
  for (int axis = 0; axis < 3; ++axis) {
    range.low[axis] = std::max(a.low[axis], b.low[axis]);
    range.high[axis] = std::min(a.high[axis], b.high[axis]);
  }
  return range;
}

CellRange windowAt(Int3 low) { return {low, low + Int3{8, 8, 8}}; }

std::int64_t windowCount(const CellRange &range) {
  const Int3 windows = (range.high - range.low + Int3{7, 7, 7}) >> 3;
  return std::int64_t{windows.x} * windows.y * windows.z;
}

/// Does the triangle lie inside this cell, without reaching the next ones?
bool isInside(const SnappedTriangle &triangle, int log2Side, Int3 cell) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const std::int64_t low = std::int64_t{cell[axis]} << log2Side;
    if (triangle.low(i) < low || triangle.high(i) >= low + (std::int64_t{1} << log2Side))
      return false;
  }
  return true;
}

/// Tests windows of cells and adds their masks.
template <typename Wide, std::size_t Boxes> class WindowTest {
public:
  WindowTest(const SnappedTriangle &triangle, const CellShape &shape, std::vector<CellMask> &masks)
      : WindowTest(triangle, shape, masks, std::make_index_sequence<Boxes>()) {}

  void operator()(const CellRange &window) {
    CellMask &mask = masks_.emplace_back(CellMask{window.low});
    for (const Separation<Wide> &box : boxes_)
      box.cover(mask, window.high - window.low);
  }

private:
  template <std::size_t... Box>
  WindowTest(const SnappedTriangle &triangle, const CellShape &shape, std::vector<CellMask> &masks,
             std::index_sequence<Box...>)
      : masks_(masks), boxes_{Separation<Wide>(triangle, shape.halves[Box], shape.log2Side)...} {}

  std::vector<CellMask> &masks_;
  std::array<Separation<Wide>, Boxes> boxes_;
};

template <typename Test> void testFewWindows(const CellRange &range, Test test) {
  for (int z = range.low.z; z < range.high.z; z += 8)
    for (int y = range.low.y; y < range.high.y; y += 8)
      for (int x = range.low.x; x < range.high.x; x += 8)
        test(intersection(windowAt({x, y, z}), range));
}

template <typename Test>
void testManyWindows(const SnappedTriangle &triangle, int log2Side, const CellRange &range, Test test) {
  std::vector<CellMask> windows;
  const CellRange within{range.low >> 3, (range.high + Int3{7, 7, 7}) >> 3};
  coverCells(triangle, CellShape::cube(log2Side + 3), within, windows);
  for (const CellMask &mask : windows)
    forEachCell(mask, [&](Int3 window) { test(intersection(windowAt(window * 8), range)); });
}

template <typename Wide, std::size_t Boxes>
void coverRange(const SnappedTriangle &triangle, const CellShape &shape, const CellRange &range,
                std::vector<CellMask> &masks) {
  WindowTest<Wide, Boxes> test(triangle, shape, masks);
  if (windowCount(range) <= kFewWindows)
    testFewWindows(range, test);
  else
    testManyWindows(triangle, shape.log2Side, range, test);
}

} // namespace

CellShape CellShape::cube(int log2Side) {
  const std::int64_t half = std::int64_t{1} << (log2Side - 1);
  return {log2Side, {{{half, half, half}}}, 1};
}

CellShape CellShape::cross(int log2Side) {
  const std::int64_t half = std::int64_t{1} << (log2Side - 1);
  return {log2Side, {{{half, 0, 0}, {0, half, 0}, {0, 0, half}}}, 3};
}

CellRange cellsOf(const SnappedTriangle &triangle, int log2Side, const CellRange &within) {
  CellRange range;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const std::int64_t least = within.low[axis];
    const std::int64_t most = within.high[axis];
    // A face between two cells belongs to both.
    const std::int64_t low = (triangle.low(i) - 1) >> log2Side;
    const std::int64_t high = (triangle.high(i) >> log2Side) + 1;
    range.low[axis] = static_cast<int>(std::clamp(low, least, most));
    range.high[axis] = static_cast<int>(std::clamp(high, least, most));
  }
  return range;
}

void coverCells(const SnappedTriangle &triangle, const CellShape &shape, const CellRange &within,
                std::vector<CellMask> &masks) {
  masks.clear();
  const CellRange range = cellsOf(triangle, shape.log2Side, within);
  if (range.empty())
    return;
  const bool isCube = shape.boxes == 1;
  if (isCube && isInside(triangle, shape.log2Side, range.low)) {
    masks.push_back({range.low, {1}});
    return;
  }
  const bool fits = Separation<std::int64_t>::fits(triangle, shape.log2Side);
  const auto cover = fits     ? isCube ? coverRange<std::int64_t, 1> : coverRange<std::int64_t, 3>
                         : isCube ? coverRange<Int128, 1>
                              : coverRange<Int128, 3>;
  cover(triangle, shape, range, masks);
}

} // namespace voxc
