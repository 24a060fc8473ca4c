// palette: states that there are few colours, and keeps each once.
//
// Contract: sets payload=palette(N) and values=apart on the format. A build that meets more than 2^N colours
// fails and names the voxel of the one too much.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult paletteOf(Format &format, int log2Colours, Diagnostics &) {
  const bool isNew = format.setAttribute(kPayloadAttribute, "palette(" + std::to_string(log2Colours) + ")");
  return format.setAttribute(kValuesAttribute, "apart") || isNew ? PassResult::Changed
                                                                 : PassResult::Unchanged;
}

PassResult palette(Format &format, Diagnostics &diagnostics) {
  return paletteOf(format, findPass("palette")->number->usual, diagnostics);
}

} // namespace voxc
