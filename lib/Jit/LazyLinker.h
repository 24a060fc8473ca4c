// Code that is compiled when it is first called. LLVM's ORC does the waiting: a call goes to a stub, which
// comes back to its linker until there is what it stands for.
#pragma once

#include "Jit.h"

#include <llvm/ExecutionEngine/Orc/LLJIT.h>
#include <llvm/ExecutionEngine/Orc/LazyReexports.h>

namespace voxc {

/// Must go before the linker that it was made for.
class LazyLinker {
public:
  /// Defines the functions of some parts, as stubs, where `jit` looks for what its objects do not define.
  static llvm::Expected<std::unique_ptr<LazyLinker>> define(llvm::orc::LLJIT &jit,
                                                            std::vector<LaterPart> parts);

private:
  std::unique_ptr<llvm::orc::LazyCallThroughManager> calls_;
  std::unique_ptr<llvm::orc::IndirectStubsManager> stubs_;
};

} // namespace voxc
