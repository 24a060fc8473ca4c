// voxc: the driver. A thin client of the libraries; each command is a file of this folder.
#include "Subcommand.h"

#include "common/Misspelling.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace voxc;
using namespace voxc::tool;

struct CommandKind {
  const char *name;
  const char *summary;
  std::unique_ptr<Subcommand> (*make)();
};

constexpr CommandKind kCommands[] = {
    {"compile", "Write the code that is generated for a format", makeCompileCommand},
    {"build", "Voxelize an input and construct its volume", makeBuildCommand},
    {"plan", "Cut the building of a volume into parts, for many processes or machines", makePlanCommand},
    {"submit", "Carry out a build plan, on processes of this machine or by Slurm", makeSubmitCommand},
    {"status", "Say what stands of a build plan", makeStatusCommand},
    {"merge", "Join the fragments of a volume", makeMergeCommand},
    {"split", "Cut a volume into fragments, the inverse of merge", makeSplitCommand},
    {"render", "Render a picture of a volume", makeRenderCommand},
    {"view", "Walk through a volume in a window", makeViewCommand},
    {"run", "Compile, build and render in one go", makeRunCommand},
    {"trace", "Trace the rays of a file through a volume", makeTraceCommand},
    {"verify", "Check a volume, and its kernel against an exact oracle", makeVerifyCommand},
    {"hard-rays", "Check the kernels of many formats on rays that are hard to trace", makeHardRaysCommand},
    {"accuracy", "Compare speed and error of a volume's kernels", makeAccuracyCommand},
    {"bench", "Measure size, speed and error of many formats", makeBenchCommand},
    {"export", "Write a volume as a dense grid, points or MagicaVoxel, or as another .hvx",
     makeExportCommand},
    {"facts", "Measure what an input is like, to choose a format by", makeFactsCommand},
    {"suggest", "Say which format an input asks for, and why", makeSuggestCommand},
    {"search", "Find the best formats for an input by measuring those that promise most", makeSearchCommand},
    {"info", "Describe a volume", makeInfoCommand},
    {"devices", "List the devices that can trace", makeDevicesCommand},
};

/// CLI11 says only that a command is missing where one is misspelt.
bool isUnknownCommand(std::string_view word) {
  return !word.starts_with('-') &&
         std::ranges::find(kCommands, word, &CommandKind::name) == std::end(kCommands);
}

/// An option before any command that voxc itself does not have.
bool isStrayOption(const CLI::App &app, std::string_view word) {
  return word.starts_with('-') && !app.get_option_no_throw(std::string(word));
}

Error unknownCommand(std::string_view word) {
  std::string names;
  for (const CommandKind &kind : kCommands)
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  const CommandKind *const like = std::ranges::min_element(
      kCommands, {}, [word](const CommandKind &kind) { return wordDistance(kind.name, word); });
  const bool isLike = wordDistance(like->name, word) <= 2;
  return Error::usage("'" + std::string(word) + "' is no command; the commands are " + names +
                      (isLike ? " (did you mean " + std::string(like->name) + "?)" : ""));
}

} // namespace

int main(int argc, char **argv) {
  CLI::App app{"A compiler for hybrid voxel formats", "voxc"};
  app.set_version_flag("--version", versionText());
  app.require_subcommand(1);

  std::vector<std::pair<CLI::App *, std::unique_ptr<Subcommand>>> commands;
  for (const CommandKind &kind : kCommands) {
    CLI::App *subcommand = app.add_subcommand(kind.name, kind.summary);
    commands.emplace_back(subcommand, kind.make()).second->declare(*subcommand);
  }

  if (argc > 1 && isStrayOption(app, argv[1])) {
    printError(
        Error::usage("'" + std::string(argv[1]) +
                     "' is no option of voxc itself; a command comes first, such as 'voxc run', and 'voxc "
                     "--help' lists them"));
    return exitCode(ErrorKind::Usage);
  }
  if (argc > 1 && isUnknownCommand(argv[1])) {
    printError(unknownCommand(argv[1]));
    return exitCode(ErrorKind::Usage);
  }
  return runTool(app, argc, argv, [&]() -> Expected<void> {
    for (auto &[subcommand, command] : commands)
      if (subcommand->parsed())
        return command->run();
    return {};
  });
}
