// values-apart: keeps the colours of voxels in blocks of their own.
//
// Contract: sets values=apart on the format. Volumes have the same voxels and colours.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult valuesApart(Format &format, Diagnostics &) {
  return format.setAttribute(kValuesAttribute, "apart") ? PassResult::Changed : PassResult::Unchanged;
}

} // namespace voxc
