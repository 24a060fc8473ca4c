// octant-counts: counts of voxels for octants of sub-volumes in place of each.
//
// Contract: sets counts=octant on the last level, where that is allowed. Volumes have the same voxels.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult octantCounts(Format &format, Diagnostics &) {
  Format fewer = format;
  Level &last = fewer.levels.back();
  if (last.attribute(kCountsAttribute) != "each" || !last.setAttribute(kCountsAttribute, "octant"))
    return PassResult::Unchanged;
  Diagnostics problems;
  verify(fewer, problems);
  if (problems.hasErrors())
    return PassResult::Unchanged;
  format = std::move(fewer);
  return PassResult::Changed;
}

} // namespace voxc
