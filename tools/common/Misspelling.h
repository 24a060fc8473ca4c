// What someone may have meant who wrote an option that there is not.
#pragma once

#include "CliNames.h"

#include <string>
#include <string_view>

namespace voxc::tool {

/// How many characters must be put in, left out or changed to make one word of the other.
std::size_t wordDistance(std::string_view a, std::string_view b);

/// What tells of a command's options: "voxc build --help".
std::string helpOf(const CLI::App &app, const CLI::App &command);

/// Why `command`, one of `app`'s or `app` itself, does not take `word`, in a sentence: an option like it is
/// offered, or the commands are named that have it.
std::string explainUnknown(const CLI::App &app, const CLI::App &command, const std::string &word);

} // namespace voxc::tool
