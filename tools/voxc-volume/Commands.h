// What can be done with a volume without a compiler.
#pragma once

#include "voxc/Support/Error.h"

#include <span>
#include <string>

namespace voxc::tool {

struct Command {
  const char *name;
  const char *arguments; ///< As the help names them, one word each.
  const char *help;
  Expected<std::string> (*run)(std::span<const std::string> arguments); ///< Returns what is told of it.
};

std::span<const Command> commands();

} // namespace voxc::tool
