// How every command is run.
#include "Command.h"

#include "Help.h"
#include "Interrupt.h"
#include "Misspelling.h"
#include "Process.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <vector>

namespace voxc::tool {
namespace {

constexpr int kUsageExit = 2;
constexpr int kDefectExit = 70;

struct ExitCode {
  ErrorKind kind;
  int code;
};

constexpr ExitCode kExitCodes[] = {
    {ErrorKind::Input, 1},
    {ErrorKind::Usage, kUsageExit},
    {ErrorKind::Environment, 3},
    {ErrorKind::Interrupted, 130},
};

/// Of words that nobody takes, the first option, or else the first.
const std::string &firstOption(const std::vector<std::string> &words) {
  const auto option =
      std::ranges::find_if(words, [](const std::string &word) { return word.starts_with('-'); });
  return option == words.end() ? words.front() : *option;
}

/// What CLI11 says, as a sentence of ours begins.
std::string inOurWords(const CLI::ParseError &failure) {
  std::string text = failure.what();
  if (text.starts_with("A "))
    text.front() = 'a';
  return text;
}

/// CLI11 tells of wrong arguments, but also of --help and --version, by throwing.
int parseFailure(CLI::App &app, const CLI::ParseError &failure) {
  if (failure.get_exit_code() == 0)
    return app.exit(failure, std::cout, std::cerr);
  const std::vector<CLI::App *> commands = app.get_subcommands();
  const CLI::App &command = commands.empty() ? app : *commands.front();
  const std::vector<std::string> words = app.remaining(true);
  printError(Error::usage(!words.empty() && dynamic_cast<const CLI::ExtrasError *>(&failure)
                              ? explainUnknown(app, command, firstOption(words))
                              : inOurWords(failure) + "; see '" + helpOf(app, command) + "'"));
  return kUsageExit;
}

} // namespace

void addCommonOptions(CLI::App &command, CommonOptions &options) {
  const OptionGroup group(command, "Common options");
  command.add_option("--stats", options.stats, "Write figures as JSON; - for standard output")
      ->type_name("FILE");
  command.add_flag("--quiet", options.quiet, "No progress and no notes");
  command.set_version_flag("--version", versionText(), "Tell the version and exit");
}

int runTool(CLI::App &app, int argc, char **argv, const std::function<Expected<void>()> &body) {
  catchInterrupts();
  if (Expected<void> prepared = prepareProcess(); !prepared) {
    printError(prepared.error());
    return exitCode(prepared.error().kind);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError &failure) {
    return parseFailure(app, failure);
  }
  try {
    Expected<void> outcome = body();
    heedInterrupt();
    if (outcome)
      return 0;
    printError(outcome.error());
    return exitCode(outcome.error().kind);
  } catch (const std::bad_alloc &) {
    Error error = Error::environment("out of memory");
    printError(error);
    return exitCode(error.kind);
  }
}

int exitCode(ErrorKind kind) {
  for (const ExitCode &row : kExitCodes)
    if (row.kind == kind)
      return row.code;
  return kDefectExit;
}

void printError(const Error &error) {
  // Diagnostics come rendered, with their own "error:" and several lines.
  bool rendered = error.message.find('\n') != std::string::npos;
  std::cerr << (rendered ? "" : "voxc: error: ") << error.message;
  if (!error.message.ends_with('\n'))
    std::cerr << '\n';
}

void printNote(std::string_view text) { std::cerr << "voxc: " << text << '\n'; }

std::string versionText() { return "voxc " VOXC_VERSION; }

} // namespace voxc::tool
