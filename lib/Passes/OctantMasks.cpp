// octant-masks: of the small grids that numbers lead to, a byte for each octant that is not empty.
//
// Contract: sets masks=octants on the last level, where that is allowed. Volumes have the same voxels.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult octantMasks(Format &format, Diagnostics &) {
  Format smaller = format;
  Level &last = smaller.levels.back();
  if (last.attribute(kMasksAttribute) != "whole" || !last.setAttribute(kMasksAttribute, "octants"))
    return PassResult::Unchanged;
  Diagnostics problems;
  verify(smaller, problems);
  if (problems.hasErrors())
    return PassResult::Unchanged;
  format = std::move(smaller);
  return PassResult::Changed;
}

} // namespace voxc
