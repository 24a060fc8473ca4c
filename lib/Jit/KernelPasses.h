// What optimises kernels: fewer passes than Clang has, in an order that suits them.
#pragma once

#include "voxc/Support/Error.h"

#include <llvm/IR/Module.h>
#include <llvm/Target/TargetMachine.h>

namespace voxc {

/// Optimises a module as Clang's front end leaves it, none of whose own passes have seen it. Functions for
/// lanes become packets; one that cannot is an error.
Expected<void> runKernelPasses(llvm::Module &module, llvm::TargetMachine &machine);

} // namespace voxc
