// short-pointers: numbers of few bits in place of offsets, to the small grids of the last level.
//
// Contract: sets pointers=N on the last level, where that is allowed and pointers are words. Volumes have
// the same voxels.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult shortPointersOf(Format &format, int bits, Diagnostics &) {
  Format shorter = format;
  Level &last = shorter.levels.back();
  if (last.attribute(kPointersAttribute) != "word" ||
      !last.setAttribute(kPointersAttribute, std::to_string(bits)))
    return PassResult::Unchanged;
  Diagnostics problems;
  verify(shorter, problems);
  if (problems.hasErrors())
    return PassResult::Unchanged;
  format = std::move(shorter);
  return PassResult::Changed;
}

PassResult shortPointers(Format &format, Diagnostics &diagnostics) {
  return shortPointersOf(format, findPass("short-pointers")->number->usual, diagnostics);
}

} // namespace voxc
