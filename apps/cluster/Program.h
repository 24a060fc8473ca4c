// Running another program and taking what it prints.
#pragma once

#include "voxc/Support/Error.h"

#include <string>
#include <vector>

namespace voxc::tool::cluster {

/// How a program ended.
struct ProgramReport {
  int exitCode = 0;   ///< 128 + the signal that ended it.
  std::string output; ///< What it wrote to standard output and to standard error, 16 MiB at most.
};

/// Runs `words[0]`, looked for in $PATH, with the other words as its arguments, to its end. Error
/// (`Environment`): there is no such program, or no process can be made.
Expected<ProgramReport> runProgram(const std::vector<std::string> &words);

} // namespace voxc::tool::cluster
