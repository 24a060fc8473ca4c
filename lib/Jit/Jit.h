// Object code as callable code in this process. No LLVM type appears here.
#pragma once

#include "ClangFrontend.h"

#include "voxc/Support/Error.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// Functions that are compiled when one of them is first called, while the call waits.
struct LaterPart {
  std::vector<std::string> functions;             ///< extern "C".
  std::function<Expected<std::string>()> compile; ///< To object code that defines them all; on any thread.
};

/// Compiled code; its functions live as long as it does.
class JitCode {
public:
  /// Links object code that `compileToObject` made for this processor. Debuggers know its functions by name;
  /// so does perf where VOXC_PERF asks for it, with the label behind each name. What the object calls and
  /// does not define may be in one of the `later` parts; where such a part then cannot be compiled, which
  /// only a defect could bring about, the process ends. Error: the linker's message.
  static Expected<JitCode> link(std::string_view object, std::string_view label = {},
                                std::vector<LaterPart> later = {});
  /// Compiles and links. Errors: as of either.
  static Expected<JitCode> compile(const std::vector<MemoryFile> &files, const ClangOptions &options,
                                   const CompileCache *cache = nullptr, std::string_view label = {});
  ~JitCode();
  JitCode(JitCode &&) noexcept;

  /// The address of an extern "C" function. Errors: there is none of this name; perf's file cannot be
  /// written.
  Expected<void *> find(const std::string &name) const;

private:
  struct State;
  explicit JitCode(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

} // namespace voxc
