// Object code as callable code in this process. No LLVM type appears here.
#pragma once

#include "ClangFrontend.h"

#include "voxc/Support/Error.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// Compiled code; its functions live as long as it does.
class JitCode {
public:
  /// Links object code that `compileToObject` made for this processor. Error: the linker's message.
  static Expected<JitCode> link(std::string_view object);
  /// Compiles and links. Errors: as of either.
  static Expected<JitCode> compile(const std::vector<MemoryFile> &files, const ClangOptions &options,
                                   const CompileCache *cache = nullptr);
  ~JitCode();
  JitCode(JitCode &&) noexcept;

  /// The address of an extern "C" function. Error: there is none of this name.
  Expected<void *> find(const std::string &name) const;

private:
  struct State;
  explicit JitCode(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

} // namespace voxc
