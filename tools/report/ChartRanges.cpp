// Finding ranges that charts have in common.
#include "report/ChartRanges.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace voxc::report {
namespace {

/// A round that is faster than all medians by more than this is drawn cut off.
constexpr double kMostAboveMedians = 1.25;
/// How many times as fast the best of one chart may be as that of another with the same axis.
constexpr double kMostApart = 3;

/// What the points of one stage take.
ChartRange ownRange(const Catalogue &catalogue, const Stage &stage) {
  ChartRange range{std::numeric_limits<double>::infinity(), 0, 0};
  double fastestRound = 0;
  for (const std::size_t i : stage.entries)
    if (const Entry &entry = catalogue.entries[i]; entry.hasPoint()) {
      range.leastBytes = std::min(range.leastBytes, *entry.bytes);
      range.mostBytes = std::max(range.mostBytes, *entry.bytes);
      range.mostSpeed = std::max(range.mostSpeed, entry.speed->median);
      fastestRound = std::max(fastestRound, entry.speed->max);
    }
  range.mostSpeed = std::min(fastestRound, kMostAboveMedians * range.mostSpeed);
  return range;
}

using Ranges = std::vector<ChartRange *>;

void shareSizes(const Ranges &ranges) {
  ChartRange all = *ranges.front();
  for (const ChartRange *range : ranges) {
    all.leastBytes = std::min(all.leastBytes, range->leastBytes);
    all.mostBytes = std::max(all.mostBytes, range->mostBytes);
  }
  for (ChartRange *range : ranges)
    range->leastBytes = all.leastBytes, range->mostBytes = all.mostBytes;
}

/// From the fastest down, each takes the axis of the one before it unless that is too long for it.
void shareSpeeds(Ranges ranges) {
  std::ranges::stable_sort(ranges, std::greater(), &ChartRange::mostSpeed);
  double most = ranges.front()->mostSpeed;
  for (ChartRange *range : ranges) {
    if (most > kMostApart * range->mostSpeed)
      most = range->mostSpeed;
    range->mostSpeed = most;
  }
}

} // namespace

std::vector<ChartRange> chartRanges(const Catalogue &catalogue) {
  std::vector<ChartRange> ranges;
  ranges.reserve(catalogue.stages.size());
  for (const Stage &stage : catalogue.stages)
    ranges.push_back(ownRange(catalogue, stage));
  std::map<std::tuple<std::string, double>, Ranges> bySize;
  std::map<std::tuple<std::string, double, bool>, Ranges> bySpeed;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Stage &stage = catalogue.stages[i];
    bySize[{stage.model, stage.resolution}].push_back(&ranges[i]);
    bySpeed[{stage.model, stage.resolution, stage.hasClock}].push_back(&ranges[i]);
  }
  for (const auto &[key, group] : bySize)
    shareSizes(group);
  for (const auto &[key, group] : bySpeed)
    shareSpeeds(group);
  return ranges;
}

} // namespace voxc::report
