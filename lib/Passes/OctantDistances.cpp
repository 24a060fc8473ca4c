// octant-distances: D levels tell empty cubes by octant in place of an L1 distance.
//
// Contract: sets metric=octant on every D level, whose M then is 15 at most, or 7 in the words of voxels. The
// voxels stay as they are.
#include "SetOnLevels.h"

namespace voxc {

PassResult octantDistances(Format &format, Diagnostics &) {
  return setOnLevels(format, 0, kMetricAttribute, "octant");
}

} // namespace voxc
