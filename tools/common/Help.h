// How commands describe themselves: help that is wrapped to the terminal, and options in groups.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace voxc::tool {

/// Options that are added to a command while this lives stand in the group `name` of its help.
class OptionGroup {
public:
  OptionGroup(CLI::App &command, const std::string &name)
      : command_(command), before_(command.option_defaults()->get_group()) {
    command.option_defaults()->group(name);
  }
  ~OptionGroup() { command_.option_defaults()->group(before_); }
  OptionGroup(const OptionGroup &) = delete;
  OptionGroup &operator=(const OptionGroup &) = delete;

private:
  CLI::App &command_;
  std::string before_;
};

/// Columns of the terminal behind a file descriptor; `usual` where it is none, or does not say.
int terminalColumns(int file, int usual);

/// Breaks words so that no line is wider than `columns`, unless a word is; lines after the first begin with
/// `indent` blanks, which count. The first begins at the column `begin`. Lines that the text has stay.
std::string wrap(std::string_view text, std::size_t columns, std::size_t indent = 0, std::size_t begin = 0);

/// Lets `app` and the commands that are added to it from now on print their help wrapped to the terminal.
void useWrappedHelp(CLI::App &app);

/// What is left of an option's help line: its names, and what it takes.
std::string optionUsage(const CLI::Option &option);

} // namespace voxc::tool
