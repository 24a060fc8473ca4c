// restart-sv: trees are walked without a stack, each lookup from the root (paper, section 4.3).
//
// Contract: sets walk=restart on every tree that has more than one cell. The volume stays as it is, and so do
// the hits. An error where a tree is unrolled: a walk is one of the two.
#include "ChooseWalk.h"

namespace voxc {

PassResult restartSv(Format &format, Diagnostics &diagnostics) {
  return chooseWalk(format, "restart", diagnostics);
}

} // namespace voxc
