// occupancy: keeps of each voxel that it is there.
//
// Contract: sets payload=occupancy on the format. Volumes have the same voxels, all of one colour, and store
// none.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult occupancy(Format &format, Diagnostics &) {
  return format.setAttribute(kPayloadAttribute, "occupancy") ? PassResult::Changed : PassResult::Unchanged;
}

} // namespace voxc
