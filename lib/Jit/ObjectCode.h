// From an optimised module of LLVM to object code.
#pragma once

#include "voxc/Support/Error.h"

#include <llvm/IR/Module.h>
#include <llvm/Target/TargetMachine.h>

#include <memory>
#include <string>

namespace voxc {

/// What makes position-independent code of a module, each function for the processor that its attributes
/// name. Error: LLVM knows no such platform.
Expected<std::unique_ptr<llvm::TargetMachine>> machineOf(const llvm::Module &module);

/// The module as object code.
Expected<std::string> objectOf(llvm::Module &module, llvm::TargetMachine &machine);

} // namespace voxc
