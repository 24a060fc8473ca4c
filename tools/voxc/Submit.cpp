// voxc submit: carries out a build plan.
#include "Figures.h"
#include "SlurmRun.h"
#include "Subcommand.h"

#include "common/Terminal.h"

#include <filesystem>

namespace voxc::tool {

namespace {

class SubmitCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    command.add("PLAN", path_, "Build plan of voxc plan").required().takes("");
    const Option local = command.add("--local", processes_, "Processes of this machine; without an engine")
                             .takes("N")
                             .between(1u, 1024u);
    const Option slurm = command.addFlag("--slurm", bySlurm_, "Hand the tasks to Slurm, as arrays of jobs");
    slurm.excludes(local);
    command.add("--partition", partition_, "Slurm's partition").takes("NAME").needs(slurm);
    command.add("--sbatch", sbatch_, "An option for sbatch, such as --sbatch=--time=30; may be repeated")
        .takes("OPTION")
        .needs(slurm);
    command.add("--poll", slurm_.pollSeconds, "Seconds between two questions to Slurm")
        .takes("S")
        .between(0.0, 3600.0)
        .showsDefault()
        .needs(slurm);
    command.addFlag("!--no-wait", slurm_.wait, "Hand over and do not wait").needs(slurm);
    addMemoryArguments(command, means_);
    command.add("--threads", means_.threads, "Threads of each task; default: one")
        .takes("N")
        .between(1u, 1024u);
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    if (processes_ == 0 && !bySlurm_)
      return Error::usage("say where the plan shall be carried out: --local N or --slurm");
    // A job may start in any folder.
    const std::string path = std::filesystem::absolute(path_).lexically_normal().string();
    auto plan = cluster::loadPlan(path);
    if (!plan)
      return plan.error();
    if (auto same = cluster::checkInput(*plan); !same)
      return same;
    Json figures;
    ProgressBar bar(common_.quiet);
    const cluster::PlanFiles files(*plan, path);
    if (auto made = files.makeFolder(); !made)
      return made;
    const PlanRun run{path, *plan, files, means_, common_, bar.progress()};
    auto done = bySlurm_ ? runBySlurm(run, slurmMeans(), figures) : runLocally(run, processes_, figures);
    if (!done)
      return done;
    bar.clear();
    return tellFigures(common_, figures);
  }

private:
  SlurmMeans slurmMeans() const {
    SlurmMeans means = slurm_;
    if (!partition_.empty())
      means.options.push_back("--partition=" + partition_);
    if (means_.threads > 1)
      means.options.push_back("--cpus-per-task=" + std::to_string(means_.threads));
    means.options.insert(means.options.end(), sbatch_.begin(), sbatch_.end());
    return means;
  }

  std::string path_;
  unsigned processes_ = 0;
  bool bySlurm_ = false;
  std::string partition_;
  std::vector<std::string> sbatch_;
  SlurmMeans slurm_;
  BuildArguments means_;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeSubmitCommand() { return std::make_unique<SubmitCommand>(); }

} // namespace voxc::tool
