// short-pointers: numbers of few bits in place of offsets, to the small grids of the last level.
//
// Contract: sets pointers=20 on the last level, where that is allowed and pointers are words. Volumes have
// the same voxels.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult shortPointers(Format &format, Diagnostics &) {
  Format shorter = format;
  Level &last = shorter.levels.back();
  if (last.attribute(kPointersAttribute) != "word" || !last.setAttribute(kPointersAttribute, "20"))
    return PassResult::Unchanged;
  Diagnostics problems;
  verify(shorter, problems);
  if (problems.hasErrors())
    return PassResult::Unchanged;
  format = std::move(shorter);
  return PassResult::Changed;
}

} // namespace voxc
