// What applications bring to the driver, where a build has them (the option VOXC_APPS): commands, and parts
// of the compiler's own. Without them NoApplications.cpp says so.
#pragma once

#include "building/Comparison.h"
#include "common/CommandLine.h"
#include "common/Json.h"
#include "options/BuildArguments.h"
#include "program/Subcommand.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace voxc::tool {

// The commands of applications; null where there are none. Those of bench are made by it alone.
std::unique_ptr<Subcommand> makeViewCommand();
std::unique_ptr<Subcommand> makeBenchCommand();
std::unique_ptr<Subcommand> makeSearchCommand();
std::unique_ptr<Subcommand> makeAccuracyCommand();
std::unique_ptr<Subcommand> makePlanCommand();
std::unique_ptr<Subcommand> makeSubmitCommand();
std::unique_ptr<Subcommand> makeStatusCommand();

/// Another way to do the work of a command: that of tasks of a build plan.
class TaskOption {
public:
  virtual ~TaskOption() = default;
  /// Adds the option to a command that has all others.
  virtual void declare(const CommandLine &command) = 0;
  /// Whether it is the work that is asked for.
  virtual bool isGiven() const = 0;
  /// Does it, and adds what was done to the figures.
  virtual Expected<void> run(const BuildArguments &means, const Progress &progress, Json &figures) = 0;
};

/// The tasks of `build` and of `merge`; null where there are none.
std::unique_ptr<TaskOption> makeBuildTasks();
std::unique_ptr<TaskOption> makeMergeTasks();

/// An output of a plan that stands and whose voxels are not those of the input, or not to be read.
struct BrokenOutput {
  std::string path;
  std::string problem; ///< What makes it no fragment, or "" if its voxels alone are wrong.
  VoxelDifferences differences;
};

/// What was found of a plan's parts and of the merges that leave fragments.
struct PlanCheck {
  std::uint64_t outputs = 0;    ///< That the plan has,
  std::uint64_t missing = 0;    ///< of which so many do not stand.
  VoxelDifferences differences; ///< Of all that stand together.
  std::vector<BrokenOutput> broken;
};

/// True if a file is a build plan, by its first words.
bool isBuildPlan(const std::string &path);

/// Compares the voxels of each fragment of the plan in the file `path` that stands with those of the input,
/// in the cubes of its share; the input is opened once. A fragment is made to a volume of its own for that.
/// Errors: the plan's and the input's; no memory; interrupted; there are no plans in this build.
Expected<PlanCheck> checkPlan(const std::string &path, const BuildArguments &means, const Progress &progress);

/// A volume as a page for browsers: its options, and what is measured for it.
class PageWriter {
public:
  virtual ~PageWriter() = default;

  /// Adds --title, --url, --device-memory, what says where a picture is taken from, --sun and cuts to a
  /// command.
  virtual void declare(const CommandLine &command) = 0;

  /// True of a file that is written as a page, by its ending.
  virtual bool isPage(const std::string &path) const = 0;

  /// Looks at the options before any work. Errors: `Usage`, as of pictures, or options of a page for what is
  /// none.
  virtual Expected<void> check(const std::string &path) const = 0;

  /// Writes the page to `path`. `source` is the file of the volume, after which the page is named if nobody
  /// says how. Errors: those of tracing and of files; more words than a browser keeps.
  virtual Expected<void> write(const Volume &volume, const std::string &source, const std::string &path,
                               const Progress &progress, Json &figures) = 0;
};

/// Null where there are no pages.
std::unique_ptr<PageWriter> makePageWriter();

/// Whether `voxc view` opens a window.
bool opensWindows();

} // namespace voxc::tool
