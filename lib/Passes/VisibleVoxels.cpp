// visible-voxels: states that no voxel has an alpha of 0.
//
// Contract: sets alpha=positive on the format. A build that meets a voxel with an alpha of 0 fails and names
// it.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult visibleVoxels(Format &format, Diagnostics &) {
  return format.setAttribute(kAlphaAttribute, "positive") ? PassResult::Changed : PassResult::Unchanged;
}

} // namespace voxc
