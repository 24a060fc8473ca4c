// Every piece of work is done once.
#include "Support/ParallelFor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace voxc {
namespace {

TEST(ParallelFor, DoesEveryPieceOnce) {
  for (const unsigned threads : {0u, 1u, 2u, 9u})
    for (const std::uint64_t count : {0u, 1u, 3u, 1000u}) {
      std::vector<std::atomic<int>> times(count);
      parallelFor(count, threads, [&](std::uint64_t i) { ++times[i]; });
      for (const auto &done : times)
        ASSERT_EQ(done, 1) << threads << " threads, " << count << " pieces";
    }
}

} // namespace
} // namespace voxc
