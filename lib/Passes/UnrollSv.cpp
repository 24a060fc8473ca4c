// unroll-sv: the walk of a tree is written out, a loop over the children of a node for each height of the
// tree.
//
// Contract: sets walk=unrolled on every tree that has more than one cell. The volume stays as it is, and so
// do the hits. An error where a tree restarts: a walk is one of the two.
#include "ChooseWalk.h"

namespace voxc {

PassResult unrollSv(Format &format, Diagnostics &diagnostics) {
  return chooseWalk(format, "unrolled", diagnostics);
}

} // namespace voxc
