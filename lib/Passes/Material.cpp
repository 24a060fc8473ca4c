// material: keeps labels in place of colours.
//
// Contract: sets payload=material(N) on the format. A build that meets a label of 2^N or more fails and names
// its voxel.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult materialOf(Format &format, int bits, Diagnostics &) {
  return format.setAttribute(kPayloadAttribute, "material(" + std::to_string(bits) + ")")
             ? PassResult::Changed
             : PassResult::Unchanged;
}

PassResult material(Format &format, Diagnostics &diagnostics) {
  return materialOf(format, findPass("material")->number->usual, diagnostics);
}

} // namespace voxc
