// whole-level-dedup: all sub-volumes of an SVDAG level share one node map (paper, section 4.3).
//
// Contract: sets dedup=level on every level that takes the attribute. The words of a volume get fewer, never
// more, and decode to the same voxels. Level 1 has one sub-volume, where both values mean the same; it is
// left alone.
#include "SetOnLevels.h"

namespace voxc {

PassResult wholeLevelDedup(Format &format, Diagnostics &) {
  return setOnLevels(format, 1, kDedupAttribute, "level");
}

} // namespace voxc
