// rgb565: keeps colours in 16 bits.
//
// Contract: sets payload=rgb565 and values=apart on the format. Volumes have the same voxels, each channel at
// most half a step from what it was, and alpha 255; a build tells the error.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult rgb565(Format &format, Diagnostics &) {
  const bool isNew = format.setAttribute(kPayloadAttribute, "rgb565");
  return format.setAttribute(kValuesAttribute, "apart") || isNew ? PassResult::Changed
                                                                 : PassResult::Unchanged;
}

} // namespace voxc
