// Threads that take the next piece until none is left.
#include "ParallelFor.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace voxc {

unsigned threadsOrAll(unsigned threads) {
  return threads > 0 ? threads : std::max(std::thread::hardware_concurrency(), 1u);
}

void parallelFor(std::uint64_t count, unsigned threads, FunctionRef<void(std::uint64_t)> work) {
  std::atomic<std::uint64_t> next = 0;
  const auto takeAll = [&] {
    for (std::uint64_t i = next++; i < count; i = next++)
      work(i);
  };
  std::vector<std::jthread> helpers;
  while (helpers.size() + 1 < std::min<std::uint64_t>(threadsOrAll(threads), count))
    helpers.emplace_back(takeAll);
  takeAll();
} // The helpers are joined.

} // namespace voxc
