// Threads that take the next piece until none is left.
#include "ParallelFor.h"

#include <algorithm>
#include <atomic>
#include <latch>
#include <system_error>

namespace voxc {

unsigned threadsOrAll(unsigned threads) {
  return threads > 0 ? threads : std::max(std::thread::hardware_concurrency(), 1u);
}

std::vector<std::jthread> startHelpers(std::uint64_t count, const std::function<void()> &work) {
  std::vector<std::jthread> helpers;
  try {
    while (helpers.size() < count)
      helpers.emplace_back(work);
  } catch (const std::system_error &) {
    return helpers; // A limit on threads: those that there are do it all.
  }
  return helpers;
}

bool canStartThreads(std::uint64_t count) {
  std::latch tried(1);
  const auto helpers = startHelpers(count, [&] { tried.wait(); });
  tried.count_down();
  return helpers.size() == count;
}

void parallelFor(std::uint64_t count, unsigned threads, FunctionRef<void(std::uint64_t)> work) {
  if (count == 0)
    return;
  std::atomic<std::uint64_t> next = 0;
  const auto takeAll = [&] {
    for (std::uint64_t i = next++; i < count; i = next++)
      work(i);
  };
  const auto helpers = startHelpers(std::min<std::uint64_t>(threadsOrAll(threads), count) - 1, takeAll);
  takeAll();
} // The helpers are joined.

} // namespace voxc
