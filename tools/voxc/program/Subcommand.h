// A command of the driver: its options and what it does. Each command is one file of the folder commands, or
// of an application (Applications.h), and a row of the table in main.cpp.
#pragma once

#include "common/Command.h"
#include "voxc/Support/Error.h"

#include <memory>

namespace voxc::tool {

class Subcommand {
public:
  virtual ~Subcommand() = default;
  /// Adds the command's options to `command`.
  virtual void declare(const CommandLine &command) = 0;
  /// Does the command's work, once the options are parsed.
  virtual Expected<void> run() = 0;
};

std::unique_ptr<Subcommand> makeCompileCommand();
std::unique_ptr<Subcommand> makeBuildCommand();
std::unique_ptr<Subcommand> makeMergeCommand();
std::unique_ptr<Subcommand> makeSplitCommand();
std::unique_ptr<Subcommand> makeAttachCommand();
std::unique_ptr<Subcommand> makeRenderCommand();
std::unique_ptr<Subcommand> makeRunCommand();
std::unique_ptr<Subcommand> makeTraceCommand();
std::unique_ptr<Subcommand> makeVerifyCommand();
std::unique_ptr<Subcommand> makeExportCommand();
std::unique_ptr<Subcommand> makeFactsCommand();
std::unique_ptr<Subcommand> makeSuggestCommand();
std::unique_ptr<Subcommand> makeInfoCommand();
std::unique_ptr<Subcommand> makeDevicesCommand();
std::unique_ptr<Subcommand> makeDoctorCommand();
std::unique_ptr<Subcommand> makeEditCommand();
std::unique_ptr<Subcommand> makeCacheCommand();
std::unique_ptr<Subcommand> makeManualCommand();
std::unique_ptr<Subcommand> makeCompletionCommand();

} // namespace voxc::tool
