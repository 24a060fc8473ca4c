// guard-lookups: where a kernel asks whether the device has ended a look-up.
#include "Passes.h"

#include "voxc/Layout/SlotKind.h"

namespace voxc {

/// A look-up that loops may be cut short where the device cuts loops: it has so many turns for all of a
/// traversal, which are enough for a single point.
void guardLookUps(Plan &plan) {
  if (plan.loops != Loops::Cut || plan.isOfPoints())
    return;
  for (std::size_t i = 0; i < plan.traversals.size(); ++i)
    if (plan.layout.strata[i].slots->lookUpLoops)
      plan.traversals[i].lookUp = Loops::Cut;
}

} // namespace voxc
