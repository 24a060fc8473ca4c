// Equal pieces of work on several threads.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/FunctionRef.h"

#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace voxc {

/// As many threads as were asked for, or for 0 as the machine has.
unsigned threadsOrAll(unsigned threads);

/// Starts up to `count` threads that do `work`, as many as the system gives; work that is taken in pieces
/// gets done by however many there are. They are joined on destruction.
std::vector<std::jthread> startHelpers(std::uint64_t count, const std::function<void()> &work);

/// True if the system lets this process have so many more threads at this moment.
bool canStartThreads(std::uint64_t count);

/// Calls `work(i)` for every i from 0 to count - 1, in any order, on so many threads, this one among them (0:
/// all of the machine). Returns when all are done. Where `work` throws, no more is begun, and the caller gets
/// the exception: one that leaves a thread would end the process.
void parallelFor(std::uint64_t count, unsigned threads, FunctionRef<void(std::uint64_t)> work);

/// The same for work that may fail, or find that it shall stop. What comes behind a failure may be left out;
/// the error is that of the least i, whichever thread was faster. Without an error all is done.
Expected<void> parallelTry(std::uint64_t count, unsigned threads,
                           FunctionRef<Expected<void>(std::uint64_t)> work);

} // namespace voxc
