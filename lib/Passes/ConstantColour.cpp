// constant-colour: states that all voxels have one colour.
//
// Contract: sets payload=constant on the format. A build that meets a voxel of a second colour fails and
// names it.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult constantColour(Format &format, Diagnostics &) {
  return format.setAttribute(kPayloadAttribute, "constant") ? PassResult::Changed : PassResult::Unchanged;
}

} // namespace voxc
