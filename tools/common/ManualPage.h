// A page of the manual, in roff, from the tables that the help of a command is printed from.
#pragma once

#include "CommandLine.h"

#include <string>
#include <string_view>

namespace voxc::tool {

/// What a page has besides its command's own tables, as roff.
struct ManualExtras {
  std::string formats;  ///< Before the options.
  std::string examples; ///< Behind them.
};

/// The whole page of a program or a command, as `man -l -` reads it.
std::string manualPage(const CommandLine &command, const ManualExtras &extras = {});

/// "voxc-bench-report": the name of a command's page, and of its file but for ".1".
std::string manualName(const CommandLine &command);
/// "voxc bench report": how it is typed.
std::string spokenName(const CommandLine &command);

/// Text as roff takes it, and the heading of a section.
std::string roffText(std::string_view text);
std::string roffSection(const std::string &name);

/// Adds --manual to a program without commands: `runTool` writes its page where that is all that is given.
void addManual(const CommandLine &program);

} // namespace voxc::tool
