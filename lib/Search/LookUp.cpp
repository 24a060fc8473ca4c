// What one level of a format tells of a cell.
#include "LookUp.h"

#include "Distances.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>

namespace voxc {

LevelView::LevelView(const Stratum &stratum, const Traversal &traversal, bool isFirst)
    : stratum(stratum), descent(traversal.descent), isFirst(isFirst), bottom(stratum.log2Cell),
      top(bottom + longest(stratum.log2Size())), branch(std::max(stratum.log2Shape.x, 1)),
      tellsGroups(stratum.isGrid() && stratum.skip == Skip::None && stratum.slots->tellsGap(stratum)) {}

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
  return isEmpty || stratum.implied ? 1 : 2;
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
