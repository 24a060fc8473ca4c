// What debuggers are told of code that no file on disk holds. No LLVM type appears here.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace voxc {

/// Object files in memory that the debugger of this process knows of. They must stay where they are until
/// they are withdrawn.
class DebuggerEntries {
public:
  DebuggerEntries();
  ~DebuggerEntries();
  DebuggerEntries(const DebuggerEntries &) = delete;
  DebuggerEntries &operator=(const DebuggerEntries &) = delete;

  /// Tells of an object file whose sections have the addresses at which they are.
  void add(const char *object, std::size_t bytes);
  /// Withdraws all.
  void withdraw();

private:
  struct Entry;
  std::vector<std::unique_ptr<Entry>> entries_;
};

} // namespace voxc
