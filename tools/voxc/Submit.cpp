// voxc submit: carries out a build plan.
#include "Figures.h"
#include "SlurmRun.h"
#include "Subcommand.h"

#include "common/Terminal.h"

#include <CLI/CLI.hpp>

#include <filesystem>

namespace voxc::tool {

namespace {

class SubmitCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override {
    app.add_option("PLAN", path_, "Build plan of voxc plan")->required()->type_name("");
    CLI::Option *local = app.add_option("--local", processes_, "Processes of this machine; without an engine")
                             ->type_name("N")
                             ->check(CLI::Range(1u, 1024u).description(""));
    CLI::Option *slurm = app.add_flag("--slurm", bySlurm_, "Hand the tasks to Slurm, as arrays of jobs");
    slurm->excludes(local);
    app.add_option("--partition", partition_, "Slurm's partition")->type_name("NAME")->needs(slurm);
    app.add_option("--sbatch", sbatch_, "An option for sbatch, such as --sbatch=--time=30; may be repeated")
        ->type_name("OPTION")
        ->needs(slurm);
    app.add_option("--poll", slurm_.pollSeconds, "Seconds between two questions to Slurm")
        ->type_name("S")
        ->check(CLI::Range(0.0, 3600.0).description(""))
        ->capture_default_str()
        ->needs(slurm);
    app.add_flag("!--no-wait", slurm_.wait, "Hand over and do not wait")->needs(slurm);
    addMemoryArguments(app, means_);
    app.add_option("--threads", means_.threads, "Threads of each task; default: one")
        ->type_name("N")
        ->check(CLI::Range(1u, 1024u).description(""));
    addCommonOptions(app, common_);
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
