// Slurm as a program sees it: arrays of jobs handed over by sbatch, asked for by squeue and sacct. Nothing
// here schedules or watches anything itself.
#pragma once

#include "voxc/Support/Error.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::tool::cluster {

/// One array of jobs: items of one level of a plan's tree.
struct SlurmArray {
  std::size_t level = 0;
  std::string indices;            ///< "0,3,5-9": $SLURM_ARRAY_TASK_ID of its jobs.
  std::vector<std::string> after; ///< Arrays that must have ended well before this one begins.
  std::vector<std::string> avoid; ///< Nodes that its jobs shall not run on, if there are others.
  std::string command;            ///< A line for the shell.
  std::string logFolder;          ///< Where what its jobs print goes: job-ARRAY-INDEX.log.
};

/// A job that waits or runs.
struct QueuedJob {
  std::string array; ///< The number that Slurm gave to it.
  std::size_t level = 0;
  std::uint64_t number = 0; ///< Its $SLURM_ARRAY_TASK_ID.
  bool isRunning = false;
  bool isHeld =
      false; ///< Slurm itself holds it back, since it could not be launched; it waits for a release.
};

/// What Slurm says of a job that has ended or runs.
struct JobAccount {
  std::string job;  ///< "123_4".
  std::string node; ///< Where it ran; "" if it never did.
  std::string state;
  double seconds = 0;
  std::optional<double> cpuSeconds; ///< Where Slurm keeps accounts.
};

class Slurm {
public:
  /// `name`: by it the jobs of a plan are known, "voxc-" and its digest. `options`: passed on to every
  /// sbatch.
  Slurm(std::string name, std::vector<std::string> options)
      : name_(std::move(name)), options_(std::move(options)) {}

  /// The jobs of the plan that wait or run. Errors (`Environment`): Slurm does not answer.
  Expected<std::vector<QueuedJob>> queue(std::size_t levels) const;
  /// Lets jobs that Slurm holds back be launched again. It drains a node that cannot launch a job, so that
  /// they come to another.
  void release(const std::vector<QueuedJob> &jobs) const;
  /// Hands over an array; returns its number. Errors (`Environment`): Slurm's own.
  Expected<std::string> submit(const SlurmArray &array) const;
  /// What became of the jobs of arrays: by Slurm's accounts or, where it keeps none, by what its controller
  /// remembers, which is the jobs that ended in the last minutes (`MinJobAge`).
  std::vector<JobAccount> accounts(const std::vector<std::string> &arrays) const;

private:
  std::string nameOf(std::size_t level) const { return name_ + "-" + std::to_string(level); }

  std::string name_;
  std::vector<std::string> options_;
};

/// Seconds of a time as sacct writes it: "1-02:03:04", "02:03:04", "03:04.567"; 0 if it is none.
double secondsOfTime(std::string_view text);

} // namespace voxc::tool::cluster
