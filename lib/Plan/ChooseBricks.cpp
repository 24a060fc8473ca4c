// choose-bricks: how construction reads the voxels below a tree.
#include "Passes.h"

namespace voxc {

/// A host hands over bricks in any case: to go through one at once saves a call and a question for each node
/// in it. Grids of voxels read bricks in their own way.
void chooseBricks(Plan &plan) {
  for (std::size_t i = 0; i < plan.constructions.size(); ++i)
    plan.constructions[i].bricks = plan.layout.holdsVoxels(i) && !plan.layout.strata[i].isGrid();
}

} // namespace voxc
