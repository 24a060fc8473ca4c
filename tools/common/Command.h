// What every command shares: its common options, how it is run, and which exit code its errors become.
#pragma once

#include "CommandLine.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Version.h"

#include <functional>
#include <string>
#include <string_view>

namespace voxc::tool {

/// The group of help that they stand in.
inline constexpr const char *kCommonOptions = "Common options";

/// Options that every command takes.
struct CommonOptions {
  std::string stats;  ///< File for the figures as JSON; "-" is standard output, "" writes none.
  bool quiet = false; ///< No progress and no notes; errors are still told.
};

/// Adds --stats, --quiet and --version to a command; --help is there already.
void addCommonOptions(const CommandLine &command, CommonOptions &options);

/// Parses the arguments, runs `body` and returns the exit code. Errors are printed to standard error:
/// 0 done, 1 bad input or a failed check, 2 usage, 3 the environment, 130 interrupted.
int runTool(const CommandLine &program, int argc, char **argv, const std::function<Expected<void>()> &body);

/// The exit code that an error becomes.
int exitCode(ErrorKind kind);

/// Prints one error (or rendered diagnostics, as they are) to standard error.
void printError(const Error &error);

/// Prints a note or warning to standard error: "voxc: TEXT".
void printNote(std::string_view text);

} // namespace voxc::tool
