// What is left to do of a build plan.
#pragma once

#include "cluster/PlanFiles.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace voxc::tool::cluster {

/// The items of each level whose outputs are missing: indices, ascending. Levels below an output that stands
/// are not looked at, for nothing asks for them any more.
class MissingWork {
public:
  using Stands = std::function<bool(const WorkItem &)>;

  /// Asks for the outputs of a tree from the top down.
  MissingWork(const MergeTree &tree, const Stands &stands);

  const std::vector<std::uint64_t> &at(std::size_t level) const { return levels_[level]; }
  std::size_t levels() const { return levels_.size(); }

private:
  void look(const MergeTree &tree, const WorkItem &item, const Stands &stands);

  std::vector<std::vector<std::uint64_t>> levels_;
};

} // namespace voxc::tool::cluster
