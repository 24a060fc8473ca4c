// drop-values: voxels whose values nobody asks for are not read.
#include "Passes.h"

namespace voxc {

/// Whether rays hit, and where, masks and references tell: a read less for each hit.
void dropValues(Plan &plan) {
  for (std::size_t i = 0; i < plan.traversals.size(); ++i)
    if (plan.layout.holdsVoxels(i) && !plan.layout.strata[i].implied && !storesValue(plan.outputs))
      plan.traversals[i].readsValues = false;
}

} // namespace voxc
