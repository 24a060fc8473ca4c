// choose-descents: what a stratum's slots and layers leave no choice of.
#include "Passes.h"

#include "voxc/Layout/SlotKind.h"

namespace voxc {

void chooseDescents(Plan &plan) {
  for (std::size_t i = 0; i < plan.traversals.size(); ++i) {
    const Stratum &stratum = plan.layout.strata[i];
    if (stratum.depth == 0)
      plan.traversals[i].descent = Descent::Single;
    else if (stratum.slots == &kHashedSlots)
      plan.traversals[i].descent = Descent::Probe;
  }
}

} // namespace voxc
