// What one level of a format tells of a cell.
#include "LookUp.h"

#include "Distances.h"

#include <algorithm>

namespace voxc {
namespace {

std::uint64_t numberOf(const LevelView &level, Int3 voxel) {
  const int side = level.top - level.bottom;
  const auto row = [&](int place) {
    return static_cast<std::uint64_t>(place >> level.bottom & ((1 << side) - 1));
  };
  return row(voxel.x) | row(voxel.y) << side | row(voxel.z) << (2 * side);
}

} // namespace

LevelView::LevelView(const Stratum &stratum, const Traversal &traversal, bool isFirst)
    : stratum(stratum), descent(traversal.descent), isFirst(isFirst), bottom(stratum.log2Cell),
      top(bottom + maxComponent(stratum.log2Size())), branch(std::max(stratum.log2Shape.x, 1)),
      region(stratum.slots->region(stratum)) {}

double wordsRead(const LevelView &level, int layers, bool isEmpty) {
  const Stratum &stratum = level.stratum;
  return stratum.depth == 0 ? 1 : stratum.slots->cost.words(stratum, layers, isEmpty);
}

std::uint64_t lineOf(const LevelView &level, Int3 voxel) {
  const Stratum &stratum = level.stratum;
  const auto line = stratum.slots->cost.line;
  return stratum.depth == 0 || !line ? 0 : line(stratum, numberOf(level, voxel));
}

std::optional<std::uint64_t> slotLineOf(const LevelView &level, Int3 voxel) {
  const auto line = level.stratum.slots->cost.slotLine;
  return level.stratum.depth == 0 || !line ? std::nullopt : line(level.stratum, numberOf(level, voxel));
}

/// The region of a distance.
EmptySpan spanOfDistance(const LevelView &level, bool asCube, const RayPosition &at, const ScenePath &path) {
  const int bottom = level.bottom;
  const Int3 voxel = at.voxel();
  const int side = 1 << (level.top - bottom);
  const Int3 cell = {voxel.x >> bottom & (side - 1), voxel.y >> bottom & (side - 1),
                     voxel.z >> bottom & (side - 1)};
  const MeasuredCube cube{path.dag(), level.stratum, level.top, path.number(level.top), level.isFirst};
  const int told = distanceAt(cube, cell, at.octant());
  if (level.region == EmptyRegion::Cube || !asCube)
    return {bottom, std::max(told, 1)};
  // The largest cube ahead whose cells are all nearer than the distance; in the sub-volume, of which it
  // speaks.
  const int inDistance = std::max((told + 2) / 3, 1);
  return {bottom, level.isFirst ? inDistance : std::min(inDistance, cellsAhead(cell, side, at.octant()))};
}

EmptySpan spanAt(const LevelView &level, int empty, bool asCube, const RayPosition &at,
                 const ScenePath &path) {
  const int bottom = level.bottom;
  if (!level.stratum.isGrid())
    return {empty, 1};
  switch (level.region) {
  case EmptyRegion::Cell:
    return {bottom, 1};
  case EmptyRegion::Ball:
  case EmptyRegion::Cube:
    return spanOfDistance(level, asCube, at, path);
  case EmptyRegion::Octant:
    return {std::min(empty, bottom + 1), 1};
  case EmptyRegion::Ahead:
  case EmptyRegion::Octants:
    break;
  }
  const bool isAllEmpty = path.hasNothingAhead(bottom, at.octant(), level.region == EmptyRegion::Octants);
  return {isAllEmpty ? bottom + 2 : std::min(empty, bottom + 1), 1};
}

} // namespace voxc
