// Threads that take the next piece until none is left.
#include "ParallelFor.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <latch>
#include <mutex>
#include <optional>
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
  std::exception_ptr thrown;
  std::mutex mutex; // Guards `thrown`.
  const auto takeAll = [&] {
    try {
      for (std::uint64_t i = next++; i < count; i = next++)
        work(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      thrown = std::current_exception();
    }
  };
  auto helpers = startHelpers(std::min<std::uint64_t>(threadsOrAll(threads), count) - 1, takeAll);
  takeAll();
  helpers.clear(); // Joins them.
  if (thrown)
    std::rethrow_exception(thrown);
}

Expected<void> parallelTry(std::uint64_t count, unsigned threads,
                           FunctionRef<Expected<void>(std::uint64_t)> work) {
  std::atomic<std::uint64_t> firstFailed = count;
  std::optional<Error> error; // Of that one.
  std::mutex mutex;
  parallelFor(count, threads, [&](std::uint64_t i) {
    if (i > firstFailed)
      return;
    Expected<void> done = work(i);
    if (done)
      return;
    const std::lock_guard lock(mutex);
    if (i > firstFailed)
      return;
    firstFailed = i;
    error = done.error();
  });
  return error ? *error : Expected<void>();
}

} // namespace voxc
