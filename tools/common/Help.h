// How commands describe themselves: help that is wrapped to the terminal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace voxc::tool {

/// Columns of the terminal behind a file descriptor; `fallback` where it is none, or does not say.
int terminalColumns(int file, int fallback);

/// Breaks words so that no line is wider than `columns`, unless a word is; lines after the first begin with
/// `indent` blanks, which count. The first begins at the column `begin`. Lines that the text has stay.
std::string wrap(std::string_view text, std::size_t columns, std::size_t indent = 0, std::size_t begin = 0);

/// Lets `app` and the commands that are added to it from now on print their help wrapped to the terminal.
void useWrappedHelp(CLI::App &app);

/// What is left of an option's help line: its names, and what it takes.
std::string optionUsage(const CLI::Option &option);

} // namespace voxc::tool
