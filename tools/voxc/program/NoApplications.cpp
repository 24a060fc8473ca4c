// A build without applications.
#include "program/Applications.h"

namespace voxc::tool {

std::unique_ptr<Subcommand> makeViewCommand() { return nullptr; }
std::unique_ptr<Subcommand> makeBenchCommand() { return nullptr; }
std::unique_ptr<Subcommand> makeSearchCommand() { return nullptr; }
std::unique_ptr<Subcommand> makeAccuracyCommand() { return nullptr; }
std::unique_ptr<Subcommand> makePlanCommand() { return nullptr; }
std::unique_ptr<Subcommand> makeSubmitCommand() { return nullptr; }
std::unique_ptr<Subcommand> makeStatusCommand() { return nullptr; }

std::unique_ptr<TaskOption> makeBuildTasks() { return nullptr; }
std::unique_ptr<TaskOption> makeMergeTasks() { return nullptr; }

bool isBuildPlan(const std::string &) { return false; }

Expected<PlanCheck> checkPlan(const std::string &, const BuildArguments &, const Progress &) {
  return Error::usage("this build has no build plans; one with -DVOXC_APPS=ON has");
}

std::unique_ptr<PageWriter> makePageWriter() { return nullptr; }

bool opensWindows() { return false; }

} // namespace voxc::tool
