// direct-walk: one loop, and in each turn of it down from the root through all levels.
//
// Contract: sets levels=direct on the format. The volume stays as it is, and so do the hits. An error where a
// tree restarts or is unrolled, or the walk is flat.
#include "ChooseWalk.h"

namespace voxc {

PassResult directWalk(Format &format, Diagnostics &diagnostics) {
  return chooseLevels(format, "direct", diagnostics);
}

} // namespace voxc
