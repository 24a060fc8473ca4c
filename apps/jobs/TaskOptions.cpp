// --plan of `build` and of `merge`.
#include "jobs/PlanOption.h"
#include "jobs/PlanTasks.h"

#include "program/Applications.h"

namespace voxc::tool {
namespace {

class BuildTasks final : public TaskOption {
public:
  void declare(const CommandLine &command) override {
    plan_.declare(command, "--task", "Parts of the plan to build, such as 0,3,5-9; those that stand are left",
                  {"FORMAT", "INPUT", "--output"},
                  {"--memory", "--scratch", "--threads", "--stats", "--quiet"});
  }
  bool isGiven() const override { return plan_.isGiven(); }
  Expected<void> run(const BuildArguments &means, const Progress &progress, Json &figures) override {
    return buildParts(plan_.path(), plan_.numbers(), means, progress, figures);
  }

private:
  PlanOption plan_;
};

class MergeTasks final : public TaskOption {
public:
  void declare(const CommandLine &command) override {
    plan_.declare(command, "--node", "Merges of the plan to do, such as 0,3,5-9; those that stand are left",
                  {"FRAGMENT", "--output"}, {"--memory", "--scratch", "--stats", "--quiet"});
  }
  bool isGiven() const override { return plan_.isGiven(); }
  Expected<void> run(const BuildArguments &means, const Progress &progress, Json &figures) override {
    return mergeParts(plan_.path(), plan_.numbers(), means, progress, figures);
  }

private:
  PlanOption plan_;
};

} // namespace

std::unique_ptr<TaskOption> makeBuildTasks() { return std::make_unique<BuildTasks>(); }

std::unique_ptr<TaskOption> makeMergeTasks() { return std::make_unique<MergeTasks>(); }

} // namespace voxc::tool
