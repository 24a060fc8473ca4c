// Declaring where jobs are carried out, and doing so.
#include "jobs/JobOptions.h"

#include "jobs/LocalRun.h"

namespace voxc::tool {

void JobOptions::declare(const CommandLine &command) {
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
}

SlurmMeans JobOptions::slurmMeans(unsigned threads) const {
  SlurmMeans means = slurm_;
  if (!partition_.empty())
    means.options.push_back("--partition=" + partition_);
  if (threads > 1)
    means.options.push_back("--cpus-per-task=" + std::to_string(threads));
  means.options.insert(means.options.end(), sbatch_.begin(), sbatch_.end());
  return means;
}

Expected<void> JobOptions::run(const Jobs &jobs, unsigned threads, const JobWatch &watch,
                               Json &figures) const {
  return bySlurm_ ? runBySlurm(jobs, slurmMeans(threads), watch, figures)
                  : runLocally(jobs, processes_, watch, figures);
}

} // namespace voxc::tool
