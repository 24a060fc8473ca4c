// Ranges that threads take one after another.
#include "ParallelRanges.h"

#include "Support/ParallelFor.h"

#include <algorithm>
#include <thread>

namespace voxc {

namespace {

constexpr std::size_t kRange = 4096;

} // namespace

std::size_t rangeCount(std::size_t count) { return (count + kRange - 1) / kRange; }

namespace {

void workOn(std::size_t range, std::size_t count, const RangeWork &work) {
  work(range, range * kRange, std::min(count, (range + 1) * kRange));
}

} // namespace

Expected<void> forEachRange(std::size_t count, unsigned threads, const Progress &progress,
                            const RangeWork &work) {
  const std::size_t ranges = rangeCount(count);
  const auto caller = std::this_thread::get_id();
  return parallelTry(ranges, threads, [&](std::uint64_t range) -> Expected<void> {
    VOXC_TRY(progress.check());
    workOn(range, count, work);
    if (std::this_thread::get_id() == caller)
      progress.at("exact hits", static_cast<double>(range) / static_cast<double>(ranges), range * kRange);
    return {};
  });
}

void forEachRange(std::size_t count, const RangeWork &work) {
  parallelFor(rangeCount(count), 0, [&](std::uint64_t range) { workOn(range, count, work); });
}

} // namespace voxc
