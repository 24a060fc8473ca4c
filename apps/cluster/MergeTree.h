// The tree in which the parts of a build plan are merged, some in a step.
#pragma once

#include <cstdint>
#include <vector>

namespace voxc::tool::cluster {

/// A piece of the work of a plan. Those of level 0 are the parts, which are built; those above are merges, of
/// which the one of the last level writes the volume.
struct WorkItem {
  std::size_t level = 0;
  std::uint64_t index = 0; ///< From 0 in its level.

  bool operator==(const WorkItem &) const = default;
};

class MergeTree {
public:
  /// The tree over so many parts, at least 1: a merge joins up to `fanIn` items that follow one another, at
  /// least 2.
  MergeTree(std::uint64_t parts, std::uint64_t fanIn);

  /// Levels, that of the parts among them: at least 2.
  std::size_t levels() const { return counts_.size(); }
  /// Items of a level.
  std::uint64_t count(std::size_t level) const { return counts_[level]; }
  /// All merges.
  std::uint64_t merges() const;

  WorkItem root() const { return {levels() - 1, 0}; }
  bool isRoot(const WorkItem &item) const { return item == root(); }
  /// The parts [first, second) below an item.
  std::pair<std::uint64_t, std::uint64_t> partsOf(const WorkItem &item) const;
  /// What a merge joins.
  std::vector<WorkItem> childrenOf(const WorkItem &item) const;

  /// Merges are numbered through, level by level: that of an item, and the item of a number below `merges`.
  std::uint64_t numberOf(const WorkItem &item) const;
  WorkItem merge(std::uint64_t number) const;

private:
  std::uint64_t fanIn_;
  std::vector<std::uint64_t> counts_; ///< Of each level.
};

} // namespace voxc::tool::cluster
