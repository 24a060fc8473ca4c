// strip-traversal: removes what concerns the kernel alone, which leaves the format as volumes store it.
//
// Contract: removes every attribute whose effect is Traversal. Idempotent.
#include "voxc/Passes/Pass.h"

namespace voxc {

PassResult stripTraversal(Format &format, Diagnostics &diagnostics) {
  Format stripped = storageFormat(format);
  if (stripped == format) {
    diagnostics.note({}, "no attribute concerns the kernel alone");
    return PassResult::Unchanged;
  }
  format = std::move(stripped);
  return PassResult::Changed;
}

} // namespace voxc
