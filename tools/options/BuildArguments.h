// The options that say with what means a volume is built and stored; none of them changes a byte of it, if
// there is one.
#pragma once

#include "common/CommandLine.h"
#include "voxc/Construct/Constructor.h"

#include <memory>
#include <string>

namespace voxc::tool {

/// As they were written; what was left out is the library's default.
struct BuildArguments {
  std::string memory; ///< Such as "512MiB"; "": a quarter of the machine.
  std::string scratch;
  unsigned threads = 0; ///< 0: all of the machine.
  bool compress = false;
  std::string maxBytes; ///< Such as "4GiB"; "": what references can reach.
};

/// Adds --memory and --scratch to a command.
void addMemoryArguments(const CommandLine &command, BuildArguments &arguments);
/// Adds --compress, which every command has that writes a volume.
void addCompressArgument(const CommandLine &command, bool &compress);
/// Adds --threads.
void addThreadsArgument(const CommandLine &command, BuildArguments &arguments);

/// Adds --max-bytes.
void addMaxBytesArgument(const CommandLine &command, BuildArguments &arguments);

/// What is wrong with a size as people write it, or "", for Option::check.
std::string sizeProblem(const std::string &text);

/// A size as people write it, "512MiB", in bytes. Trusts that a validator of these options took it.
std::uint64_t bytesOf(const std::string &size);

/// The most words that a volume may have.
std::uint64_t maxWordsOf(const BuildArguments &arguments);

/// The bound on memory. Taken as late as possible: what is resident at this moment does not count.
std::shared_ptr<WorkingMemory> makeWorkingMemory(const BuildArguments &arguments);

/// The number of threads.
unsigned threadsOf(const BuildArguments &arguments);

} // namespace voxc::tool
