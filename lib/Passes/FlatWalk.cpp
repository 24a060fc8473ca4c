// flat-walk: one loop through the nodes of all levels, in place of a loop for each.
//
// Contract: sets levels=flat on the format. The volume stays as it is, and so do the hits. An error where a
// tree restarts or is unrolled: the loop has a stack of its own.
#include "ChooseWalk.h"

namespace voxc {

PassResult flatWalk(Format &format, Diagnostics &diagnostics) {
  return chooseLevels(format, "flat", diagnostics);
}

} // namespace voxc
