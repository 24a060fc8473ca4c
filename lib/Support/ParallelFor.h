// Equal pieces of work on several threads.
#pragma once

#include "voxc/Support/FunctionRef.h"

#include <cstdint>

namespace voxc {

/// As many threads as were asked for, or for 0 as the machine has.
unsigned threadsOrAll(unsigned threads);

/// Calls `work(i)` for every i from 0 to count - 1, in any order, on so many threads, this one among them (0:
/// all of the machine). Returns when all are done.
void parallelFor(std::uint64_t count, unsigned threads, FunctionRef<void(std::uint64_t)> work);

} // namespace voxc
