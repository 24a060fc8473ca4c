// C++ text to LLVM IR with Clang; the one file that includes Clang's frontend is ClangFrontend.cpp.
#pragma once

#include "Jit.h"

#include "voxc/Support/Error.h"

#include <memory>
#include <vector>

namespace llvm {
class LLVMContext;
class Module;
} // namespace llvm

namespace voxc {

/// The optimised module of files[0], in `context`.
Expected<std::unique_ptr<llvm::Module>> compileToModule(const std::vector<MemoryFile> &files,
                                                        llvm::LLVMContext &context);

} // namespace voxc
