// place-stops: where the traversal of a kernel of detail=cone may stop. It stops only above what can be
// searched for a colour, so that it stops at the same places where no colour is asked for.
#include "Passes.h"

#include "voxc/Layout/SlotKind.h"

namespace voxc {
namespace {

/// Slots of a grid in which a colour is searched one by one, as log2: more would take longer than the
/// traversal that is saved.
constexpr int kLog2SearchedSlots = 12;

bool isSearchable(const Stratum &stratum) {
  return !stratum.slots->hasEmptySlots || stratum.log2Children() <= kLog2SearchedSlots;
}

} // namespace

void placeStops(Plan &plan) {
  if (!plan.stopsAboveVoxels())
    return;
  bool searchableBelow = true;
  for (std::size_t i = plan.traversals.size(); i-- > 0;) {
    const Stratum &stratum = plan.layout.strata[i];
    Traversal &traversal = plan.traversals[i];
    const bool hasInnerNodes = !stratum.isGrid() && stratum.depth > 0;
    traversal.stops = searchableBelow && (!plan.layout.holdsVoxels(i) || hasInnerNodes);
    searchableBelow = searchableBelow && isSearchable(stratum);
    traversal.sampled =
        plan.outputs.colour && ((hasInnerNodes && traversal.stops) || (i > 0 && searchableBelow));
  }
}

} // namespace voxc
