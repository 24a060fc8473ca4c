// inline-leaves: the value of a leaf of a G level moves into the slot that led to it.
//
// Contract: sets leaves=in-slot on every G level. The words of a volume get fewer, and decode to the same
// voxels.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult inlineLeaves(Format &format, Diagnostics &) {
  bool changed = false;
  for (Level &level : format.levels)
    changed |= level.setAttribute(kLeavesAttribute, "in-slot");
  return changed ? PassResult::Changed : PassResult::Unchanged;
}

} // namespace voxc
