// voxc status: what stands of a build plan, and what waits or runs.
#include "jobs/PlanRun.h"
#include "jobs/SlurmRun.h"

#include "cluster/NumberList.h"
#include "common/Statistics.h"
#include "options/Figures.h"
#include "program/Applications.h"

#include <cstdio>
#include <filesystem>

namespace voxc::tool {

using namespace cluster;

namespace {

class StatusCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    command.add("PLAN", path_, "Build plan of voxc plan").required().takes("");
    command.addFlag("--slurm", bySlurm_, "Ask Slurm what waits and runs");
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    const std::string path = std::filesystem::absolute(path_).lexically_normal().string();
    auto plan = VOXC_TRY(loadPlan(path));
    const PlanRun run(path, std::move(plan), {});
    VOXC_TRY(run.checkFigures(common_));
    std::vector<QueuedJob> queue;
    if (bySlurm_)
      queue = VOXC_TRY(slurmOf(run, {}).queue(run.levels()));
    const auto missing = VOXC_TRY(run.missing());
    const Json figures = figuresOf(run, missing, queue);
    if (tellsOnStdout(common_))
      print(figures);
    return writeStatistics(common_.stats, figures);
  }

private:
  static Json figuresOf(const PlanRun &run, const Jobs::Missing &missing,
                        const std::vector<QueuedJob> &queue) {
    Json figures;
    const MergeTree tree = run.plan().tree();
    figures["digest"] = run.files().digest();
    figures["volume"] = run.files().output(tree.root());
    figures["complete"] = countOf(missing) == 0;
    for (std::size_t level = 0; level < missing.size(); ++level) {
      std::uint64_t waiting = 0;
      std::uint64_t running = 0;
      for (const QueuedJob &job : queue)
        if (job.level == level)
          ++(job.isRunning ? running : waiting);
      figures["levels"].push_back({{"items", tree.count(level)},
                                   {"missing", missing[level].size()},
                                   {"waiting", waiting},
                                   {"running", running},
                                   {"missing_list", numberListText(missing[level])}});
    }
    return figures;
  }

  static void print(const Json &figures) {
    std::size_t level = 0;
    for (const Json &row : figures["levels"]) {
      const std::string what = level == 0 ? "parts" : "merges " + std::to_string(level);
      const std::string list = row["missing_list"];
      std::printf("%-10s %6llu, missing %llu%s%s, waiting %llu, running %llu\n", what.c_str(),
                  row["items"].get<unsigned long long>(), row["missing"].get<unsigned long long>(),
                  list.empty() ? "" : ": ", list.c_str(), row["waiting"].get<unsigned long long>(),
                  row["running"].get<unsigned long long>());
      ++level;
    }
    std::printf("%s %s\n", figures["volume"].get<std::string>().c_str(),
                figures["complete"].get<bool>() ? "is complete" : "is not complete");
  }

  std::string path_;
  bool bySlurm_ = false;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeStatusCommand() { return std::make_unique<StatusCommand>(); }

} // namespace voxc::tool
