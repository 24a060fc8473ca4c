// The options that say with what means a volume is built; none of them changes a byte of it.
#pragma once

#include "voxc/Construct/Constructor.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace voxc::tool {

/// As they were written; what was left out is the library's default.
struct BuildArguments {
  std::string memory; ///< Such as "512MiB"; "": a quarter of the machine.
  std::string scratch;
  unsigned threads = 0; ///< 0: all of the machine.
};

/// Adds --memory and --scratch to a command.
void addMemoryArguments(CLI::App &app, BuildArguments &arguments);
/// Adds --threads.
void addThreadsArgument(CLI::App &app, BuildArguments &arguments);

/// The bound on memory. Taken as late as possible: what is resident at this moment does not count.
std::shared_ptr<WorkingMemory> makeWorkingMemory(const BuildArguments &arguments);

/// The number of threads.
unsigned threadsOf(const BuildArguments &arguments);

} // namespace voxc::tool
