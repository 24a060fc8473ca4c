// Ranges that threads take one after another.
#include "ParallelRanges.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace voxc {

namespace {

constexpr std::size_t kRange = 4096;

} // namespace

std::size_t rangeCount(std::size_t count) { return (count + kRange - 1) / kRange; }

bool forEachRange(std::size_t count, unsigned threads, const Progress &progress,
                  const std::function<void(std::size_t, std::size_t, std::size_t)> &work) {
  const std::size_t ranges = rangeCount(count);
  const unsigned wanted = threads > 0 ? threads : std::max(std::thread::hardware_concurrency(), 1u);
  std::atomic<std::size_t> next = 0;
  const auto takeRanges = [&](bool reports) {
    for (std::size_t range; !progress.stopped() && (range = next++) < ranges;) {
      work(range, range * kRange, std::min(count, (range + 1) * kRange));
      if (reports)
        progress.at("exact hits", static_cast<double>(range) / static_cast<double>(ranges), range * kRange);
    }
  };
  std::vector<std::jthread> helpers;
  for (std::size_t i = 1; i < std::min<std::size_t>(wanted, ranges); ++i)
    helpers.emplace_back(takeRanges, false);
  takeRanges(true);
  helpers.clear(); // Joins them.
  return !progress.stopped();
}

} // namespace voxc
