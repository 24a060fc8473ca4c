// Carrying out a build plan, on processes of this machine.
#pragma once

#include "BuildArguments.h"

#include "cluster/BuildPlan.h"
#include "cluster/PlanFiles.h"
#include "cluster/Work.h"
#include "common/Command.h"
#include "common/Json.h"
#include "voxc/Support/Progress.h"

#include <string>
#include <vector>

namespace voxc::tool {

/// A plan that is being carried out.
struct PlanRun {
  std::string path; ///< Of the plan.
  cluster::BuildPlan plan;
  cluster::PlanFiles files;
  BuildArguments means; ///< Memory, scratch and threads of each task.
  CommonOptions common;
  Progress progress;

  cluster::MissingWork missing() const;
  /// The words of the command that does items of a level, but for the program's name.
  std::vector<std::string> command(std::size_t level, const std::string &numbers) const;
  /// The items of a level as its command calls them.
  std::vector<std::uint64_t> numbersOf(std::size_t level, const std::vector<std::uint64_t> &indices) const;
};

/// Does what is missing on `processes` processes at a time, level after level. What a process leaves undone
/// is done again by another one, as long as some of it gets done. Errors: those of a task that fails twice,
/// or the work was stopped.
Expected<void> runLocally(const PlanRun &run, unsigned processes, Json &figures);

} // namespace voxc::tool
