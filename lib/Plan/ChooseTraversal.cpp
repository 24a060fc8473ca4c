// choose-traversal: the traversal that was fastest on camera rays among those that can do what is asked.
#include "Passes.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>

namespace voxc {
namespace {

/// Each nested level repeats the whole step. From here on that makes a kernel that takes long to compile, and
/// rays of a packet wait for each other at each change of level.
constexpr std::size_t kManyLevels = 8;
/// A direct traversal goes through every layer in each turn.
constexpr int kFewLayers = 8;

int layersOf(const Layout &layout) {
  int layers = 0;
  for (const Stratum &stratum : layout.strata)
    layers += std::max(stratum.depth, 1);
  return layers;
}

/// True if most turns of a direct traversal end in the first level, with a long step.
bool leapsFromTheTop(const Layout &layout) {
  const Stratum &top = layout.strata.front();
  return top.slots->region(top) == EmptyRegion::Cube && layersOf(layout) <= kFewLayers;
}

/// True for a tree made of grids that tell of empty cells around one: its nodes are small, and a nested
/// traversal would soon leave each.
bool isTreeOfGrids(const Layout &layout) {
  return layout.strata.size() > 2 && std::all_of(layout.strata.begin() + 1, layout.strata.end(), defersValue);
}

} // namespace

void chooseTraversal(Plan &plan) {
  if (plan.isOfPoints())
    return;
  const auto goesItsOwnWay = [](const Traversal &traversal) { return kindOf(traversal.descent).nestsAlone; };
  // Of one descent a ray can wait for all pages; of a traversal that keeps its place, for none that it has
  // left.
  if (plan.addressing == Addressing::Paged) {
    plan.levelTraversal = LevelTraversal::Direct;
    for (std::size_t i = 0; i < plan.traversals.size(); ++i)
      if (goesItsOwnWay(plan.traversals[i]))
        plan.traversals[i].descent = defaultDescent(plan.layout.strata[i]);
    return;
  }
  const bool needsNesting = plan.stopsAboveVoxels() || std::ranges::any_of(plan.traversals, goesItsOwnWay);
  if (needsNesting)
    plan.levelTraversal = LevelTraversal::Nested;
  if (!kindOf(plan.levelTraversal).isOpen)
    return;
  const bool isBestFromTheTop =
      plan.layout.strata.size() >= kManyLevels || leapsFromTheTop(plan.layout) || isTreeOfGrids(plan.layout);
  plan.levelTraversal = isBestFromTheTop ? LevelTraversal::Direct : LevelTraversal::Nested;
}

} // namespace voxc
