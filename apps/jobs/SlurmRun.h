// Carrying out jobs by Slurm.
#pragma once

#include "jobs/Jobs.h"

#include "cluster/Slurm.h"
#include "common/Json.h"

namespace voxc::tool {

/// How Slurm is used.
struct SlurmMeans {
  std::vector<std::string> options; ///< Passed on to sbatch: "--partition=long".
  double pollSeconds = 5;           ///< Between two questions to Slurm.
  bool wait = true;                 ///< Until all stands.
};

/// The jobs as Slurm knows them.
cluster::Slurm slurmOf(const Jobs &jobs, const SlurmMeans &means);

/// Hands over what is missing and neither waits nor runs already: an array for each level, which begins when
/// those below have ended well. Waits for them, hands over again what failed as long as some of it got done,
/// and once more to other nodes, and tells what the jobs took by Slurm's accounting. Errors: Slurm does not
/// answer, a job that fails twice, or the wait was stopped, which leaves the jobs to run.
Expected<void> runBySlurm(const Jobs &jobs, const SlurmMeans &means, const JobWatch &watch, Json &figures);

} // namespace voxc::tool
