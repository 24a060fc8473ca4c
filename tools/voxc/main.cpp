// voxc: the driver. A thin client of the libraries; each command is a file of its own.
#include "common/CommandLine.h"
#include "common/Interrupt.h"
#include "common/Misspelling.h"
#include "help/Examples.h"
#include "program/Applications.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace voxc;
using namespace voxc::tool;

// The groups of commands in the help.
constexpr const char *kMake = "Making volumes";
constexpr const char *kUse = "Using volumes";
constexpr const char *kChoose = "Choosing a format";
constexpr const char *kCheck = "Checking";
constexpr const char *kLarge = "Building in parts";
constexpr const char *kHelp = "About voxc itself";

struct CommandKind {
  const char *group;
  const char *name;
  const char *summary;
  std::unique_ptr<Subcommand> (*make)();
};

constexpr CommandKind kCommands[] = {
    {kMake, "compile", "Write the code that is generated for a format", makeCompileCommand},
    {kMake, "build", "Voxelize an input and construct its volume", makeBuildCommand},
    {kMake, "edit", "Replace boxes of a volume, building only what they touch", makeEditCommand},
    {kMake, "attach", "Give the voxels of a volume named attributes, such as normals", makeAttachCommand},
    {kUse, "render", "Render a picture of a volume", makeRenderCommand},
    {kUse, "view", "Show a volume in a window", makeViewCommand},
    {kUse, "run", "Compile, build and render in one go", makeRunCommand},
    {kUse, "trace", "Trace the rays of a file through a volume", makeTraceCommand},
    {kUse, "export",
     "Write a volume as another kind of file: points, a mesh, slices, MagicaVoxel, NanoVDB, VTK or a page",
     makeExportCommand},
    {kUse, "info", "Describe a volume or another input", makeInfoCommand},
    {kUse, "devices", "List the devices that can trace", makeDevicesCommand},
    {kChoose, "bench", "Measure size, speed and error of many formats", makeBenchCommand},
    {kChoose, "facts", "Measure what an input is like, to choose a format by", makeFactsCommand},
    {kChoose, "suggest", "Say which format an input asks for, and why", makeSuggestCommand},
    {kChoose, "search", "Find the best formats for an input by measuring those that promise most",
     makeSearchCommand},
    {kCheck, "verify", "Check a volume, and its kernel against an exact oracle", makeVerifyCommand},
    {kCheck, "accuracy", "Compare speed and error of a volume's kernels", makeAccuracyCommand},
    {kLarge, "plan", "Cut the building of a volume into parts, for many processes or machines",
     makePlanCommand},
    {kLarge, "submit", "Carry out a build plan, on processes of this machine or by Slurm", makeSubmitCommand},
    {kLarge, "status", "Say what stands of a build plan", makeStatusCommand},
    {kLarge, "merge", "Join the fragments of a volume", makeMergeCommand},
    {kLarge, "split", "Cut a volume into fragments, the inverse of merge", makeSplitCommand},
    {kHelp, "doctor", "Say whether this machine has what voxc needs, and how to mend what it lacks",
     makeDoctorCommand},
    {kHelp, "cache", "Say what is kept of compiled code, or clear it", makeCacheCommand},
    {kHelp, "manual", "Write the manual page of a command, or all of them", makeManualCommand},
    {kHelp, "completion", "Write what a shell needs to complete this command line", makeCompletionCommand},
};

/// CLI11 says only that a command is missing where one is misspelt.
bool isUnknownCommand(std::string_view word) {
  return !word.starts_with('-') &&
         std::ranges::find(kCommands, word, &CommandKind::name) == std::end(kCommands);
}

/// A command that other builds have.
bool isLackingCommand(const CommandLine &program, std::string_view word) {
  return !word.starts_with('-') &&
         std::ranges::none_of(program.commands(),
                              [word](const CommandLine &command) { return command.name() == word; });
}

/// An option before any command that voxc itself does not have.
bool isStrayOption(const CommandLine &program, std::string_view word) {
  return word.starts_with('-') && !program.find(word);
}

/// What has been a command, and where it is now.
struct MovedCommand {
  const char *name;
  const char *place;
};

constexpr MovedCommand kMovedCommands[] = {
    {"hard-rays", "the program voxc-hard-rays does it, which a build of the sources has beside voxc"},
};

Error unknownCommand(std::string_view word) {
  const auto moved = std::ranges::find(kMovedCommands, word, &MovedCommand::name);
  if (moved != std::end(kMovedCommands))
    return Error::usage("'" + std::string(word) + "' is no command any more; " + moved->place);
  std::string names;
  for (const CommandKind &kind : kCommands)
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  const CommandKind *const like = std::ranges::min_element(
      kCommands, {}, [word](const CommandKind &kind) { return wordDistance(kind.name, word); });
  const bool isLike = wordDistance(like->name, word) <= 2;
  return Error::usage("'" + std::string(word) + "' is no command; the commands are " + names +
                      (isLike ? " (did you mean " + std::string(like->name) + "?)" : ""));
}

/// `voxc help`, `voxc help COMMAND` and `voxc version`, as the options that say the same.
std::vector<char *> inOptions(int argc, char **argv) {
  static char help[] = "--help", version[] = "--version";
  std::vector<char *> words(argv, argv + argc);
  const std::string_view first = argc > 1 ? argv[1] : "";
  if (first == "version" || first == "-V")
    words = {argv[0], version};
  if (first == "help") {
    words.erase(words.begin() + 1);
    words.push_back(help);
  }
  return words;
}

} // namespace

int main(int count, char **given) {
  catchInterrupts(); // Whoever is interrupted while options are declared says so, too.
  std::vector<char *> words = inOptions(count, given);
  const int argc = static_cast<int>(words.size());
  char **const argv = words.data();
  const CommandLine program("voxc", "A compiler for hybrid voxel formats");
  program.addVersion(versionText());
  program.requireCommands(1, 1);

  std::vector<std::pair<CommandLine, std::unique_ptr<Subcommand>>> commands;
  for (const CommandKind &kind : kCommands) {
    std::unique_ptr<Subcommand> action = kind.make();
    if (!action)
      continue; // One of an application that this build has not.
    const CommandLine command = program.addCommand(kind.name, kind.summary, kind.group);
    commands.emplace_back(command, std::move(action)).second->declare(command);
    addExamples(command);
  }
  // Last, for commands take over what there is when they are added.
  program.footer("'voxc COMMAND --help' says more. To begin with: voxc run builtin:terrain -o terrain.png");

  if (argc > 1 && isStrayOption(program, argv[1])) {
    printError(Error::usage("'" + std::string(argv[1]) +
                            "' is no option of voxc itself; a command comes first, such as 'voxc run', and "
                            "'voxc --help' lists them"));
    return exitCode(ErrorKind::Usage);
  }
  if (argc > 1 && isUnknownCommand(argv[1])) {
    printError(unknownCommand(argv[1]));
    return exitCode(ErrorKind::Usage);
  }
  if (argc > 1 && isLackingCommand(program, argv[1])) {
    printError(Error::usage(
        "'" + std::string(argv[1]) +
        "' is a command of an application, and this build has none; one with -DVOXC_APPS=ON has"));
    return exitCode(ErrorKind::Usage);
  }
  return runTool(program, argc, argv, [&]() -> Expected<void> {
    for (auto &[command, action] : commands)
      if (command.isGiven())
        return action->run();
    return {};
  });
}
