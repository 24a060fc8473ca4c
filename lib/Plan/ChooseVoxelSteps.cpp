// choose-voxel-steps: where the empty spans that a nested traversal steps over are single voxels.
#include "Passes.h"

#include "voxc/Layout/SlotKind.h"

namespace voxc {

/// A step over one voxel needs neither the empty span's faces nor a search for the cell behind them.
void chooseVoxelSteps(Plan &plan) {
  if (!kindOf(plan.levelTraversal).nests)
    return;
  for (std::size_t i = 0; i < plan.traversals.size(); ++i) {
    const Stratum &stratum = plan.layout.strata[i];
    plan.traversals[i].voxelSteps = stratum.isGrid() && stratum.log2Cell == 0 && !reportsEmptyRegion(stratum);
  }
}

} // namespace voxc
