// What stands at the end of a command's help: examples, and what a FORMAT is.
#pragma once

#include "common/CommandLine.h"

#include <span>
#include <string>
#include <string_view>

namespace voxc::tool {

struct Example {
  std::string_view command; ///< The driver's: "build".
  std::string_view line;    ///< As it is typed.
  std::string_view does;    ///< What comes of it.
};

/// Of all commands, in an order of their own.
std::span<const Example> examples();

/// What a FORMAT is, in a few lines that are made of the table of level kinds.
std::string formatHelp();

/// Ends the help of a command with its examples, and with what a FORMAT is where it takes one.
void addExamples(const CommandLine &command);

} // namespace voxc::tool
