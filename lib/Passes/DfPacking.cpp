// df-packing: the distance of an empty cell of a D level moves into the cell's own word, which has no use for
// it.
//
// Contract: sets distances=in-slot on every D level. The words of a volume get fewer, and decode to the same
// voxels. An error where the last level is a D and the format does not state alpha=positive: nothing would
// tell a distance from a voxel.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult dfPacking(Format &format, Diagnostics &diagnostics) {
  Format packed = format;
  for (Level &level : packed.levels)
    level.setAttribute(kDistancesAttribute, "in-slot");
  verify(packed, diagnostics);
  if (diagnostics.hasErrors() || packed == format)
    return PassResult::Unchanged;
  format = std::move(packed);
  return PassResult::Changed;
}

} // namespace voxc
