// Carrying out a build plan: its parts and merges as jobs.
#pragma once

#include "jobs/Jobs.h"

#include "cluster/BuildPlan.h"
#include "cluster/PlanFiles.h"
#include "common/Command.h"
#include "options/BuildArguments.h"

#include <string>
#include <vector>

namespace voxc::tool {

/// A plan that is being carried out. Level 0 are the parts, the others merges by their numbers.
class PlanRun final : public Jobs {
public:
  /// `path`: of the plan, absolute. `means`: memory, scratch and threads of each task.
  PlanRun(std::string path, cluster::BuildPlan plan, BuildArguments means)
      : path_(std::move(path)), plan_(std::move(plan)), files_(plan_, path_), means_(std::move(means)) {}
  PlanRun(const PlanRun &) = delete;
  PlanRun &operator=(const PlanRun &) = delete;

  const cluster::BuildPlan &plan() const { return plan_; }
  const cluster::PlanFiles &files() const { return files_; }
  /// Refuses figures that would go over the plan's volume or its parts. Error: `Usage`.
  Expected<void> checkFigures(const CommonOptions &common) const;

  std::size_t levels() const override { return plan_.tree().levels(); }
  Expected<Missing> missing() const override;
  std::vector<std::string> command(std::size_t level, const std::string &numbers) const override;
  std::uint64_t costOf(std::size_t level, std::uint64_t number) const override;
  std::string name() const override { return "voxc-" + files_.digest(); }
  std::string folder() const override { return files_.folder(); }
  std::string itemName(std::size_t level) const override { return level == 0 ? "a part" : "a merge"; }
  std::string allName() const override { return "the plan's outputs"; }

private:
  std::string path_;
  cluster::BuildPlan plan_;
  cluster::PlanFiles files_;
  BuildArguments means_;
};

} // namespace voxc::tool
