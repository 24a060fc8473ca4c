// A child process, whose memory and crashes are its own: this very executable with other arguments, or
// another.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"

#include <functional>
#include <string>
#include <vector>

namespace voxc::tool {

/// How a child ended.
struct ChildReport {
  bool succeeded = false;
  std::string failure; ///< If not: the last line that it wrote to standard error, or its signal.
  int exitCode = 0;    ///< 127 if the program cannot be started; -1 if a signal ended it.
  std::string errors;  ///< The end of what it wrote to standard error.
};

/// Runs `voxc ARGUMENT...` to its end; its standard output is dropped. `poll` is called now and then
/// meanwhile. If `progress` is stopped the child is ended, and if this process ends the child does too. A
/// child that alone is interrupted has failed. Errors: `Interrupted`; `Environment` if no process can be
/// made.
Expected<ChildReport> runChild(const std::vector<std::string> &arguments, const Progress &progress,
                               const std::function<void()> &poll);

/// The same of the program that `words` begins with, by its path; what it writes to standard output is
/// written to that of this process.
Expected<ChildReport> runProgram(const std::vector<std::string> &words, const Progress &progress);

} // namespace voxc::tool
