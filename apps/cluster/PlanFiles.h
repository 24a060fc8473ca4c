// The files of a build plan: where its outputs lie, and whether they stand.
#pragma once

#include "cluster/BuildPlan.h"

#include <string>

namespace voxc::tool::cluster {

/// Outputs lie in a folder beside the plan, under names that hold the plan's digest and their range of cubes:
/// those of another plan are never taken for its own.
class PlanFiles {
public:
  /// `path`: of the plan.
  PlanFiles(const BuildPlan &plan, const std::string &path);

  const std::string &folder() const { return folder_; }
  const std::string &digest() const { return digest_; }
  /// Makes the folder. Error: `Environment`.
  Expected<void> makeFolder() const;

  /// The fragment or, of the root, the volume that an item of the plan's tree writes.
  std::string output(const WorkItem &item) const;

  /// Notes that the volume was written, of parts that are known to be whole: the digest of its content.
  Expected<void> noteVolume() const;

  /// True if the output of an item is there and is whole: its checksum is that of its bytes.
  bool stands(const WorkItem &item) const;

private:
  std::string noteOfVolume() const;
  bool volumeStands() const;

  const BuildPlan &plan_;
  MergeTree tree_;
  std::string folder_;
  std::string volume_;
  std::string digest_;
};

} // namespace voxc::tool::cluster
