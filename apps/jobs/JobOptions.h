// The options that say where jobs are carried out: on this machine, or by Slurm.
#pragma once

#include "jobs/Jobs.h"
#include "jobs/SlurmRun.h"

#include "common/CommandLine.h"
#include "common/Json.h"

#include <string>
#include <vector>

namespace voxc::tool {

class JobOptions {
public:
  /// Adds --local, --slurm, --partition, --sbatch, --poll and --no-wait to a command.
  void declare(const CommandLine &command);

  /// Was a place named?
  bool isGiven() const { return processes_ > 0 || bySlurm_; }
  bool bySlurm() const { return bySlurm_; }
  /// Of this machine; 0 by Slurm.
  unsigned processes() const { return processes_; }
  /// Whether what was handed over is waited for.
  bool waits() const { return slurm_.wait; }

  /// Carries jobs out where the options say; a place was named. `threads`: of each job, for which Slurm is
  /// asked; 0: what it gives. Adds to the figures what was missing and what it took. Errors: those of
  /// `runLocally` and `runBySlurm`.
  Expected<void> run(const Jobs &jobs, unsigned threads, const JobWatch &watch, Json &figures) const;

private:
  SlurmMeans slurmMeans(unsigned threads) const;

  unsigned processes_ = 0;
  bool bySlurm_ = false;
  std::string partition_;
  std::vector<std::string> sbatch_;
  SlurmMeans slurm_;
};

} // namespace voxc::tool
