// How every command is run.
#include "Command.h"

#include "FiguresFile.h"
#include "Files.h"
#include "Interrupt.h"
#include "ManualPage.h"
#include "Misspelling.h"
#include "Process.h"
#include "Signature.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <span>
#include <utility>
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

/// The exit code of what ended so. What was printed may have failed unseen.
int finish(Expected<void> outcome) {
  if (outcome)
    outcome = flushStandardOutput();
  if (outcome)
    return 0;
  printError(outcome.error());
  return exitCode(outcome.error().kind);
}

/// CLI11 tells of wrong arguments, but also of --help and --version, by throwing.
int parseFailure(const CommandLine &program, const CLI::ParseError &failure) {
  if (failure.get_exit_code() == 0) {
    program.app().exit(failure, std::cout, std::cerr);
    return finish({});
  }
  const std::vector<CommandLine> commands = program.commands();
  const auto given = std::ranges::find_if(commands, &CommandLine::isGiven);
  const CommandLine &command = given == commands.end() ? program : *given;
  const std::vector<std::string> words = program.app().remaining(true);
  printError(Error::usage(!words.empty() && dynamic_cast<const CLI::ExtrasError *>(&failure)
                              ? explainUnknown(program, command, firstOption(words))
                              : inOurWords(failure) + "; see '" + helpOf(program, command) + "'"));
  return kUsageExit;
}

/// Of the command that was given, such as import of bench, or of a program without any.
Expected<void> checkFiguresOf(const CommandLine &program) {
  const std::vector<CommandLine> commands = program.commands();
  const auto given = std::ranges::find_if(commands, &CommandLine::isGiven);
  return given == commands.end() ? checkFiguresFile(program) : checkFiguresOf(*given);
}

} // namespace

void addCommonOptions(const CommandLine &command, CommonOptions &options) {
  const OptionGroup group(command, kCommonOptions);
  command.add("--stats", options.stats, "Write figures as JSON; - for standard output")
      .takes("FILE")
      .notEmpty();
  command.addFlag("--quiet", options.quiet, "No progress and no notes");
  command.addVersion(versionText());
}

int runTool(const CommandLine &program, int argc, char **argv, const std::function<Expected<void>()> &body) {
  signAs(program.name().c_str());
  catchInterrupts();
  if (Expected<void> prepared = prepareProcess(); !prepared)
    return finish(std::move(prepared));
  const std::span<char *const> words(argv, static_cast<std::size_t>(argc));
  if (program.find("--manual") && std::ranges::count(words, std::string_view("--manual")) > 0) {
    std::fputs(manualPage(program).c_str(), stdout);
    return finish({});
  }
  try {
    program.app().parse(argc, argv);
  } catch (const CLI::ParseError &failure) {
    return parseFailure(program, failure);
  }
  try {
    Expected<void> outcome = checkFiguresOf(program);
    if (outcome)
      outcome = body();
    heedInterrupt();
    return finish(std::move(outcome));
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
  std::cerr << (rendered ? "" : std::string(signature()) + ": error: ") << error.message;
  if (!error.message.ends_with('\n'))
    std::cerr << '\n';
}

void printNote(std::string_view text) { std::cerr << signature() << ": " << text << '\n'; }

} // namespace voxc::tool
