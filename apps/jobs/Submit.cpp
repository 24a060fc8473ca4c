// voxc submit: carries out a build plan.
#include "jobs/JobOptions.h"
#include "jobs/PlanRun.h"

#include "cluster/PlanLock.h"
#include "common/Command.h"
#include "common/Terminal.h"
#include "options/Figures.h"
#include "program/Applications.h"

#include <filesystem>

namespace voxc::tool {

namespace {

class SubmitCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    command.add("PLAN", path_, "Build plan of voxc plan").required().takes("");
    jobs_.declare(command);
    addMemoryArguments(command, means_);
    command.add("--threads", means_.threads, "Threads of each task; default: one")
        .takes("N")
        .between(1u, 1024u);
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    if (!jobs_.isGiven())
      return Error::usage("say where the plan shall be carried out: --local N or --slurm");
    // A job may start in any folder.
    const std::string path = std::filesystem::absolute(path_).lexically_normal().string();
    auto plan = VOXC_TRY(cluster::loadPlan(path));
    VOXC_TRY(cluster::checkInput(plan));
    Json figures;
    ProgressBar bar(common_.quiet);
    const PlanRun run(path, std::move(plan), means_);
    VOXC_TRY(run.checkFigures(common_));
    VOXC_TRY(run.files().makeFolder());
    const auto lock = cluster::PlanLock::take(run.files().folder(), bar.progress(), [this] {
      if (!common_.quiet)
        printNote("note: the plan is being carried out by another voxc submit, or tasks of one are left; "
                  "waiting for them to end");
    });
    if (!lock)
      return lock.error();
    VOXC_TRY(jobs_.run(run, means_.threads, {bar.progress(), common_.quiet}, figures));
    bar.clear();
    return tellFigures(common_, figures);
  }

private:
  std::string path_;
  JobOptions jobs_;
  BuildArguments means_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeSubmitCommand() { return std::make_unique<SubmitCommand>(); }

} // namespace voxc::tool
