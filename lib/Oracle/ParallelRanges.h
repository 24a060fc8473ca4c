// Work on rays that is shared out over threads in ranges.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"

#include <cstddef>
#include <functional>

namespace voxc {

/// How many ranges `forEachRange` makes of `count` things.
std::size_t rangeCount(std::size_t count);

/// What is done with a range.
using RangeWork = std::function<void(std::size_t range, std::size_t begin, std::size_t end)>;

/// Calls `work` for every range of [0, count) on so many threads (0: as many as the machine has), this one
/// among them, which reports progress. Which ranges there are does not depend on the threads. Error:
/// interrupted, with some ranges left out.
Expected<void> forEachRange(std::size_t count, unsigned threads, const Progress &progress,
                            const RangeWork &work);

/// The same on all threads of the machine, to the end.
void forEachRange(std::size_t count, const RangeWork &work);

} // namespace voxc
