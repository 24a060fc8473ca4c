// Work on rays that is shared out over threads in ranges.
#pragma once

#include "voxc/Support/Progress.h"

#include <cstddef>
#include <functional>

namespace voxc {

/// How many ranges `forEachRange` makes of `count` things.
std::size_t rangeCount(std::size_t count);

/// Calls `work(range, begin, end)` for every range of [0, count) on so many threads (0: as many as the
/// machine has), this one among them, which reports progress. Which ranges there are does not depend on the
/// threads. False if it was stopped, with some ranges left out.
bool forEachRange(std::size_t count, unsigned threads, const Progress &progress,
                  const std::function<void(std::size_t range, std::size_t begin, std::size_t end)> &work);

} // namespace voxc
