// The least bound that so many runs can keep, found by halving.
#include "cluster/EvenCut.h"

#include <algorithm>
#include <numeric>

namespace voxc::tool::cluster {
namespace {

/// The ends of runs that cost no more than `bound`, each as long as it can be. A single cost above the bound
/// is a run of its own.
std::vector<std::uint64_t> runsWithin(std::span<const std::uint64_t> costs, std::uint64_t bound) {
  std::vector<std::uint64_t> ends;
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (sum != 0 && sum + costs[i] > bound) {
      ends.push_back(i);
      sum = 0;
    }
    sum += costs[i];
  }
  ends.push_back(costs.size());
  return ends;
}

/// Cuts the dearest runs in two until there are `count`, so that no process goes without while others have
/// much.
void cutFurther(std::span<const std::uint64_t> costs, std::vector<std::uint64_t> &ends, std::uint64_t count) {
  const auto sumOf = [&](std::uint64_t begin, std::uint64_t end) {
    return std::accumulate(costs.begin() + static_cast<std::ptrdiff_t>(begin),
                           costs.begin() + static_cast<std::ptrdiff_t>(end), std::uint64_t{0});
  };
  while (ends.size() < count) {
    std::size_t dearest = ends.size();
    std::uint64_t most = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const std::uint64_t begin = i == 0 ? 0 : ends[i - 1];
      const std::uint64_t sum = ends[i] - begin > 1 ? sumOf(begin, ends[i]) : 0;
      if (sum > most) {
        most = sum;
        dearest = i;
      }
    }
    if (dearest == ends.size())
      break; // No run has two costs.
    const std::uint64_t begin = dearest == 0 ? 0 : ends[dearest - 1];
    std::uint64_t middle = begin + 1;
    for (std::uint64_t sum = costs[begin]; middle + 1 < ends[dearest] && 2 * (sum + costs[middle]) <= most;
         ++middle)
      sum += costs[middle];
    ends.insert(ends.begin() + static_cast<std::ptrdiff_t>(dearest), middle);
  }
  ends.resize(count, costs.size());
}

} // namespace

std::vector<std::uint64_t> cutEvenly(std::span<const std::uint64_t> costs, std::uint64_t count) {
  std::uint64_t most = std::accumulate(costs.begin(), costs.end(), std::uint64_t{0});
  std::uint64_t least = costs.empty() ? 0 : *std::max_element(costs.begin(), costs.end());
  while (least < most) {
    const std::uint64_t bound = least + (most - least) / 2;
    if (runsWithin(costs, bound).size() <= count)
      most = bound;
    else
      least = bound + 1;
  }
  std::vector<std::uint64_t> ends = runsWithin(costs, most);
  cutFurther(costs, ends, count);
  return ends;
}

} // namespace voxc::tool::cluster
