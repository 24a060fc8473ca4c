// What one level of a format tells of a cell.
#include "LookUp.h"

#include "Distances.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>

namespace voxc {
namespace {

/// Masks of so many cells, two words, have no counts.
constexpr int kLog2Uncounted = 6;
constexpr int kLog2LineWords = 4;
/// Cells a word of a mask.
constexpr int kLog2MaskCells = 5;
/// Cells whose slots lie on one line, about: of a surface, one in eight is not empty.
constexpr int kLog2SlotCells = 7;

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
      top(bottom + longest(stratum.log2Size())), branch(std::max(stratum.log2Shape.x, 1)),
      tellsGroups(stratum.isGrid() && stratum.skip == Skip::None && stratum.slots->tellsGap(stratum)),
      isMasked(stratum.isGrid() && stratum.depth > 0 && stratum.slots->tellsByMasks && !tellsGroups),
      isCounted(isMasked && stratum.log2Children() > kLog2Uncounted && (!stratum.implied || stratum.ranked)) {
}

double wordsRead(const LevelView &level, int layers, bool isEmpty) {
  const Stratum &stratum = level.stratum;
  if (stratum.depth == 0)
    return 1;
  if (!stratum.isGrid()) {
    const int found = isEmpty ? layers - 1 : layers; // Layers that had a child.
    const int masks = level.branch == 1 ? 1 : 2;
    const int leaf = isEmpty ? 0 : stratum.implied ? -1 : stratum.cells == Cells::Word ? 1 : 0;
    return masks * layers + found + leaf;
  }
  if (stratum.isInOctants()) // The array's begin, the head, octants, and cells where the octant has some.
    return isEmpty ? 5 : 6.5;
  if (level.tellsGroups) // A number is a field in two words, and leads on from where the array begins.
    return !level.tellsWhole() ? 1 : isEmpty ? 2 : stratum.isIndexed() ? 5 : 3;
  if (stratum.slots->lookUpLoops)
    return 4; // The head and an entry: most probes find their cell, or a free entry, at once.
  if (stratum.slots->keepsEmpty)
    return isEmpty && stratum.skip != Skip::None && stratum.empty == Empty::Zero ? 2 : 1;
  return isEmpty || stratum.implied ? 1 : level.isCounted ? 3 : 2;
}

std::uint64_t lineOf(const LevelView &level, Int3 voxel) {
  const Stratum &stratum = level.stratum;
  if (level.tellsGroups || stratum.depth == 0)
    return 0;
  const std::uint64_t number = numberOf(level, voxel);
  if (stratum.slots->lookUpLoops) // Anywhere.
    return number;
  if (level.isMasked)
    return number >> (kLog2LineWords + kLog2MaskCells - (level.isCounted ? 1 : 0));
  const bool isBeside = stratum.skip != Skip::None && stratum.empty == Empty::Zero;
  return number >> (kLog2LineWords - (isBeside ? 1 : 0));
}

std::optional<std::uint64_t> slotLineOf(const LevelView &level, Int3 voxel) {
  return level.isCounted && !level.stratum.implied ? std::optional(numberOf(level, voxel) >> kLog2SlotCells)
                                                   : std::nullopt;
}

Gap gapAt(const LevelView &level, int empty, bool asCube, const RayPosition &at, const ScenePath &path) {
  const int bottom = level.bottom;
  if (!level.stratum.isGrid())
    return {empty, 1};
  if (level.tellsGroups)
    return level.tellsWhole() && path.hasNothingAhead(bottom, at.octant(), level.stratum.isInOctants())
               ? Gap{bottom + 2, 1}
               : Gap{std::min(empty, bottom + 1), 1};
  if (level.stratum.skip == Skip::None)
    return {bottom, 1};
  const Int3 voxel = at.voxel();
  const int side = 1 << (level.top - bottom);
  const Int3 cell = {voxel.x >> bottom & (side - 1), voxel.y >> bottom & (side - 1),
                     voxel.z >> bottom & (side - 1)};
  const MeasuredCube cube{path.dag(), level.stratum, level.top, path.number(level.top), level.isFirst};
  const int told = distanceAt(cube, cell, at.octant());
  if (level.stratum.skip == Skip::Octant || !asCube)
    return {bottom, std::max(told, 1)};
  // The largest cube ahead whose cells are all nearer than the distance; in the sub-volume, of which it
  // speaks.
  const int inDistance = std::max((told + 2) / 3, 1);
  return {bottom, level.isFirst ? inDistance : std::min(inDistance, cellsAhead(cell, side, at.octant()))};
}

} // namespace voxc
