// Counting the levels of a tree of merges.
#include "cluster/MergeTree.h"

#include <algorithm>
#include <numeric>

namespace voxc::tool::cluster {

MergeTree::MergeTree(std::uint64_t parts, std::uint64_t fanIn) : fanIn_(fanIn), counts_{parts} {
  do
    counts_.push_back((counts_.back() + fanIn_ - 1) / fanIn_);
  while (counts_.back() > 1);
}

std::uint64_t MergeTree::merges() const {
  return std::accumulate(counts_.begin() + 1, counts_.end(), std::uint64_t{0});
}

std::pair<std::uint64_t, std::uint64_t> MergeTree::partsOf(const WorkItem &item) const {
  const auto bound = [&](std::uint64_t index) {
    for (std::size_t level = 0; level < item.level; ++level)
      index = std::min(index * fanIn_, counts_.front());
    return index;
  };
  return {bound(item.index), bound(item.index + 1)};
}

std::vector<WorkItem> MergeTree::childrenOf(const WorkItem &item) const {
  std::vector<WorkItem> children;
  const std::uint64_t end = std::min((item.index + 1) * fanIn_, counts_[item.level - 1]);
  for (std::uint64_t index = item.index * fanIn_; index < end; ++index)
    children.push_back({item.level - 1, index});
  return children;
}

std::uint64_t MergeTree::numberOf(const WorkItem &item) const {
  return std::accumulate(counts_.begin() + 1, counts_.begin() + static_cast<std::ptrdiff_t>(item.level),
                         item.index);
}

WorkItem MergeTree::merge(std::uint64_t number) const {
  std::size_t level = 1;
  for (; number >= counts_[level]; ++level)
    number -= counts_[level];
  return {level, number};
}

} // namespace voxc::tool::cluster
