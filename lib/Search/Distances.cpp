// Distances that the cells of a sub-volume tell.
#include "Distances.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <bit>

namespace voxc {
namespace {

/// Cells from `low` to `high`, both included.
struct CellBox {
  Int3 low;
  Int3 high;
};

/// Calls visit(number, box) for the children of a cube that are not empty, until it returns false; `cells` is
/// the side of a child in cells.
template <typename Visit>
bool visitOctants(const SceneDag::Node &node, Int3 low, int cells, const Visit &visit) {
  std::uint32_t mask = node.mask;
  for (const std::uint32_t child : node.children) {
    const Int3 at = low + mortonCell(static_cast<std::uint64_t>(std::countr_zero(mask))) * cells;
    mask &= mask - 1;
    if (!visit(child, CellBox{at, {at.x + cells - 1, at.y + cells - 1, at.z + cells - 1}}))
      return false;
  }
  return true;
}

/// How far an interval lies from a place.
int distanceTo(int place, int low, int high) { return std::max({low - place, place - high, 0}); }

class Search {
public:
  Search(const MeasuredCube &cube, Int3 cell) : cube_(cube), bottom_(cube.stratum.log2Cell), cell_(cell) {}

  /// The L1 distance to the nearest cell that is not empty, `reach` at most.
  int nearest(int reach) {
    nearest_ = reach;
    approach(cube_.top, cube_.number, {});
    return nearest_;
  }

  /// The side of the largest empty cube that begins in the cell, `most` at most.
  int largestCube(unsigned octant, int most) const {
    int empty = 1;
    while (empty < most) { // By halves: a cube in an empty one is empty.
      const int side = (empty + most + 1) / 2;
      if (isEmpty(cube_.top, cube_.number, {}, cubeAhead(octant, side)))
        empty = side;
      else
        most = side - 1;
    }
    return empty;
  }

private:
  CellBox cubeAhead(unsigned octant, int side) const {
    const auto low = [&](int place, unsigned axis) {
      return (octant >> axis & 1) != 0 ? place : place - side + 1;
    };
    const Int3 at = {low(cell_.x, 0), low(cell_.y, 1), low(cell_.z, 2)};
    return {at, {at.x + side - 1, at.y + side - 1, at.z + side - 1}};
  }

  bool isEmpty(int height, std::size_t number, Int3 low, const CellBox &box) const {
    if (height == bottom_)
      return false;
    return visitOctants(cube_.dag.node(height, number), low, 1 << (height - 1 - bottom_),
                        [&](std::size_t child, const CellBox &at) {
                          const bool apart = at.low.x > box.high.x || at.low.y > box.high.y ||
                                             at.low.z > box.high.z || at.high.x < box.low.x ||
                                             at.high.y < box.low.y || at.high.z < box.low.z;
                          return apart || isEmpty(height - 1, child, at.low, box);
                        });
  }

  void approach(int height, std::size_t number, Int3 low) {
    if (height == bottom_) {
      nearest_ = distanceTo(cell_.x, low.x, low.x) + distanceTo(cell_.y, low.y, low.y) +
                 distanceTo(cell_.z, low.z, low.z);
      return;
    }
    visitOctants(cube_.dag.node(height, number), low, 1 << (height - 1 - bottom_),
                 [&](std::size_t child, const CellBox &at) {
                   const int least = distanceTo(cell_.x, at.low.x, at.high.x) +
                                     distanceTo(cell_.y, at.low.y, at.high.y) +
                                     distanceTo(cell_.z, at.low.z, at.high.z);
                   if (least < nearest_)
                     approach(height - 1, child, at.low);
                   return true;
                 });
  }

  const MeasuredCube &cube_;
  int bottom_;
  Int3 cell_;
  int nearest_ = 0;
};

} // namespace

int cellsAhead(Int3 cell, int side, unsigned octant) {
  const auto room = [&](int place, unsigned axis) {
    return (octant >> axis & 1) != 0 ? side - place : place + 1;
  };
  return std::min({room(cell.x, 0), room(cell.y, 1), room(cell.z, 2)});
}

int distanceAt(const MeasuredCube &cube, Int3 cell, unsigned octant) {
  const int side = 1 << (cube.top - cube.stratum.log2Cell);
  const int reach = static_cast<int>(std::min<std::uint32_t>(cube.stratum.distances()->reach, 3u << 21));
  if (reportsBall(cube.stratum))
    return Search(cube, cell).nearest(reach);
  const int most = cube.isWhole ? reach : std::min(reach, cellsAhead(cell, side, octant));
  return Search(cube, cell).largestCube(octant, most);
}

} // namespace voxc
