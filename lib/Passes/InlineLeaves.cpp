// inline-leaves: the value of a leaf of a G level moves into the slot that led to it.
//
// Contract: sets leaves=in-slot on every G level. The words of a volume get fewer, and decode to the same
// voxels.
#include "SetOnLevels.h"

namespace voxc {

PassResult inlineLeaves(Format &format, Diagnostics &) {
  return setOnLevels(format, 0, kLeavesAttribute, "in-slot");
}

} // namespace voxc
