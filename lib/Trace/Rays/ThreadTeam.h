// Threads that share a range of work evenly, phase by phase.
#pragma once

#include "Support/ParallelFor.h"

#include <cstddef>

namespace voxc {

class ThreadTeam {
public:
  /// Of so many threads, the caller's among them; 0: all of the machine.
  explicit ThreadTeam(unsigned threads) : threads_(threadsOrAll(threads)) {}

  /// How many shares a range has.
  unsigned size() const { return threads_; }

  /// Calls work(first, last, share) for every share of [0, count), side by side; the same count always has
  /// the same shares. Returns when all are done.
  template <typename Work> void share(std::size_t count, const Work &work) const {
    const auto begin = [&](std::size_t share) {
      return count / threads_ * share + count % threads_ * share / threads_;
    };
    parallelFor(threads_, threads_, [&](std::uint64_t share) {
      work(begin(share), begin(share + 1), static_cast<unsigned>(share));
    });
  }

private:
  unsigned threads_;
};

} // namespace voxc
