// voxc-volume: converts, traces and verifies volumes, where there is no compiler.
#include "Commands.h"

#include "Support/Platform/Arguments.h"

#include <algorithm>
#include <cstdio>

namespace {

using namespace voxc;
using namespace voxc::tool;

std::string usage() {
  std::string text = "Usage: voxc-volume COMMAND ARGUMENTS\n";
  for (const Command &command : commands())
    text += std::string("\n  ") + command.name + " " + command.arguments + "\n      " + command.help + "\n";
  return text + "\nKERNEL is a library made of what voxc compile --emit=cpu writes: docs/windows.md.\n";
}

Expected<std::string> run(std::span<const std::string> arguments) {
  if (arguments.empty() || arguments[0] == "--help")
    return usage();
  const auto command =
      std::ranges::find(commands(), arguments[0], [](const Command &each) { return each.name; });
  if (command == commands().end())
    return Error::usage("there is no command '" + arguments[0] + "'; --help tells which there are");
  const std::string wanted = command->arguments;
  if (arguments.size() - 1 != static_cast<std::size_t>(std::ranges::count(wanted, ' ')) + 1)
    return Error::usage(arguments[0] + " takes " + wanted);
  return command->run(arguments.subspan(1));
}

/// As of `voxc`: docs/command-line.md.
int exitCode(ErrorKind kind) {
  switch (kind) {
  case ErrorKind::Input:
    return 1;
  case ErrorKind::Usage:
    return 2;
  case ErrorKind::Environment:
    return 3;
  default:
    return 130;
  }
}

} // namespace

int main(int argc, char **argv) {
  const Expected<std::string> told = run(platform::argumentsOf(argc, argv));
  if (!told) {
    std::fprintf(stderr, "voxc-volume: error: %s\n", told.error().message.c_str());
    return exitCode(told.error().kind);
  }
  std::printf("%s\n", told->c_str());
}
