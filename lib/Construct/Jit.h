// C++ text to callable code in this process. No LLVM type appears here.
#pragma once

#include "voxc/Support/Error.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// A file that the compiled text may include.
struct MemoryFile {
  std::string name;
  std::string_view text;
};

/// Compiled code; its functions live as long as it does.
class JitCode {
public:
  /// Compiles freestanding C++20 (`files[0]`, which may include the others) for this machine.
  /// Error: the compiler's diagnostics.
  static Expected<JitCode> compile(const std::vector<MemoryFile> &files);
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
