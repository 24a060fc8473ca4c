// What someone may have meant who wrote an option that there is not.
#pragma once

#include "CommandLine.h"

#include <string>
#include <string_view>

namespace voxc::tool {

/// How many characters must be put in, left out or changed to make one word of the other.
std::size_t wordDistance(std::string_view a, std::string_view b);

/// What tells of a command's options: "voxc build --help".
std::string helpOf(const CommandLine &program, const CommandLine &command);

/// Why `command`, one of `program`'s or `program` itself, does not take `word`, in a sentence: an option like
/// it is offered, or the commands are named that have it.
std::string explainUnknown(const CommandLine &program, const CommandLine &command, const std::string &word);

} // namespace voxc::tool
