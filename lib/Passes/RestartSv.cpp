// restart-sv: trees are walked without a stack, each lookup from the root (paper, section 4.3).
//
// Contract: sets walk=restart on every tree that has more than one cell. The volume stays as it is, and so do
// the hits.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult restartSv(Format &format, Diagnostics &) {
  bool changed = false;
  for (Level &level : format.levels)
    if (level.parameter(ParameterRole::Side) > 0)
      changed |= level.setAttribute(kWalkAttribute, "restart");
  return changed ? PassResult::Changed : PassResult::Unchanged;
}

} // namespace voxc
