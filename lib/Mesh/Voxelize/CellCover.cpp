// Windows of 8x8x8 cells over a triangle's box; large boxes are searched by cells eight times as large.
#include "Mesh/Voxelize/CellCover.h"

#include "Mesh/Voxelize/Separation.h"

#include <algorithm>
#include <optional>
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

/// Takes the cells with a coordinate out of a mask.
void takeOut(CellMask &mask, std::size_t axis, int coordinate) {
  const int place = coordinate - mask.low[static_cast<int>(axis)];
  if (place < 0 || place > 7)
    return;
  if (axis == 2) {
    mask.slices[static_cast<std::size_t>(place)] = 0;
    return;
  }
  const std::uint64_t cells =
      axis == 0 ? std::uint64_t{0x0101010101010101} << place : std::uint64_t{0xff} << 8 * place;
  for (std::uint64_t &slice : mask.slices)
    slice &= ~cells;
}

/// Tests windows of cells by their segments, without some ends.
template <typename Wide> class SegmentTest {
public:
  SegmentTest(const SnappedTriangle &triangle, int log2Side, const SegmentEnds &ends,
              std::vector<CellMask> &masks)
      : masks_(masks) {
    const std::int64_t half = std::int64_t{1} << (log2Side - 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (ends.leftOut[axis] == 0)
        continue;
      Point64 reach{};
      reach[axis] = half;
      // Whether the triangle holds a point beside the centre is whether one beside the triangle holds the
      // centre.
      SnappedTriangle beside = triangle;
      for (Point64 &corner : beside.corners)
        corner[axis] -= ends.leftOut[axis] * half;
      segments_[axis] = Segment{Separation<Wide>(triangle, reach, log2Side),
                                Separation<Wide>(beside, Point64{}, log2Side), ends.keptIn[axis]};
    }
  }

  void operator()(const CellRange &window) {
    const Int3 size = window.high - window.low;
    CellMask &mask = masks_.emplace_back(CellMask{window.low});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!segments_[axis])
        continue;
      CellMask met{window.low};
      CellMask leftOut{window.low};
      segments_[axis]->whole.cover(met, size);
      segments_[axis]->end.cover(leftOut, size);
      takeOut(leftOut, axis, segments_[axis]->keptIn);
      for (std::size_t z = 0; z < 8; ++z)
        mask.slices[z] |= met.slices[z] & ~leftOut.slices[z];
    }
  }

private:
  struct Segment {
    Separation<Wide> whole;
    Separation<Wide> end;
    int keptIn;
  };

  std::vector<CellMask> &masks_;
  std::array<std::optional<Segment>, 3> segments_;
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

template <typename Test>
void testWindows(const SnappedTriangle &triangle, int log2Side, const CellRange &range, const Test &test) {
  if (windowCount(range) <= kFewWindows)
    testFewWindows(range, test);
  else
    testManyWindows(triangle, log2Side, range, test);
}

template <typename Wide, std::size_t Boxes>
void coverRange(const SnappedTriangle &triangle, const CellShape &shape, const CellRange &range,
                std::vector<CellMask> &masks) {
  testWindows(triangle, shape.log2Side, range, WindowTest<Wide, Boxes>(triangle, shape, masks));
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

void coverSegments(const SnappedTriangle &triangle, int log2Side, const SegmentEnds &ends,
                   const CellRange &within, std::vector<CellMask> &masks) {
  masks.clear();
  const CellRange range = cellsOf(triangle, log2Side, within);
  if (range.empty())
    return;
  if (Separation<std::int64_t>::fits(triangle, log2Side))
    testWindows(triangle, log2Side, range, SegmentTest<std::int64_t>(triangle, log2Side, ends, masks));
  else
    testWindows(triangle, log2Side, range, SegmentTest<Int128>(triangle, log2Side, ends, masks));
}

} // namespace voxc
