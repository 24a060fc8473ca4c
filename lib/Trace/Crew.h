// Threads that share a range of work evenly, phase by phase.
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace voxc {

class Crew {
public:
  /// The caller's thread and `threads - 1` others; at least 1.
  explicit Crew(unsigned threads) : threads_(std::max(threads, 1u)) {}

  /// How many shares a range has.
  unsigned size() const { return threads_; }

  /// Calls work(first, last, share) for every share of [0, count), each on a thread of its own; the same
  /// count always has the same shares. Returns when all are done.
  template <typename Work> void share(std::size_t count, const Work &work) const {
    const auto begin = [&](unsigned share) {
      return count / threads_ * share + count % threads_ * share / threads_;
    };
    std::vector<std::jthread> others;
    for (unsigned share = 1; share < threads_; ++share)
      others.emplace_back([&, share] { work(begin(share), begin(share + 1), share); });
    work(begin(0), begin(1), 0);
  }

private:
  unsigned threads_;
};

} // namespace voxc
