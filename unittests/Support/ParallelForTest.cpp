// Every piece of work is done once.
#include "Support/ParallelFor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <string>
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

/// An exception that left a helping thread would end the process.
TEST(ParallelFor, HandsExceptionsOn) {
  for (const unsigned threads : {1u, 4u}) {
    std::atomic<int> done = 0;
    const auto work = [&](std::uint64_t i) {
      if (i == 40)
        throw std::bad_alloc();
      ++done;
    };
    EXPECT_THROW(parallelFor(100000, threads, work), std::bad_alloc);
    EXPECT_LT(done, 100000 - 1) << "work went on";
  }
}

/// Of several errors that of the least piece, and all before it is done.
TEST(ParallelTry, TellsTheFirstError) {
  for (const unsigned threads : {1u, 2u, 9u})
    for (int round = 0; round < 50; ++round) {
      std::vector<std::atomic<int>> times(300);
      const auto work = [&](std::uint64_t i) -> Expected<void> {
        ++times[i];
        return i % 100 == 70 ? Error::input(std::to_string(i)) : Expected<void>();
      };
      const auto done = parallelTry(times.size(), threads, work);
      ASSERT_FALSE(done);
      EXPECT_EQ(done.error().message, "70");
      for (std::size_t i = 0; i <= 70; ++i)
        ASSERT_EQ(times[i], 1);
    }
}

TEST(ParallelTry, DoesAllWithoutAnError) {
  std::atomic<int> done = 0;
  EXPECT_TRUE(parallelTry(1000, 3, [&](std::uint64_t) { return ++done, Expected<void>(); }));
  EXPECT_EQ(done, 1000);
}

} // namespace
} // namespace voxc
