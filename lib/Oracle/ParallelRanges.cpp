// Ranges that threads take one after another.
#include "ParallelRanges.h"

#include "Support/ParallelFor.h"

#include <algorithm>
#include <atomic>

namespace voxc {

namespace {

constexpr std::size_t kRange = 4096;

} // namespace

std::size_t rangeCount(std::size_t count) { return (count + kRange - 1) / kRange; }

bool forEachRange(std::size_t count, unsigned threads, const Progress &progress,
                  const std::function<void(std::size_t, std::size_t, std::size_t)> &work) {
  const std::size_t ranges = rangeCount(count);
  const std::uint64_t helping =
      std::min<std::uint64_t>(threadsOrAll(threads), std::max<std::size_t>(ranges, 1)) - 1;
  std::atomic<std::size_t> next = 0;
  const auto takeRanges = [&](bool reports) {
    for (std::size_t range; !progress.stopped() && (range = next++) < ranges;) {
      work(range, range * kRange, std::min(count, (range + 1) * kRange));
      if (reports)
        progress.at("exact hits", static_cast<double>(range) / static_cast<double>(ranges), range * kRange);
    }
  };
  auto helpers = startHelpers(helping, [&] { takeRanges(false); });
  takeRanges(true);
  helpers.clear(); // Joins them.
  return !progress.stopped();
}

} // namespace voxc
