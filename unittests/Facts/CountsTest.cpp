// Counting in bounded memory: sets that thin themselves out, and counts that join to groups.
#include "Facts/DistinctSet.h"
#include "Facts/WordTally.h"

#include <gtest/gtest.h>

#include <cmath>

namespace voxc::test {
namespace {

TEST(DistinctSet, IsExactUpToItsBound) {
  DistinctSet set(1000);
  EXPECT_EQ(set.count(), (DistinctCount{0, true}));
  for (int round = 0; round < 3; ++round)
    for (std::uint64_t value = 1; value <= 1000; ++value)
      set.insert(value << 7);
  EXPECT_EQ(set.count(), (DistinctCount{1000, true}));
  set.insert(3);
  EXPECT_FALSE(set.count().exact);
}

TEST(DistinctSet, EstimatesBeyondItsBound) {
  constexpr std::size_t kMost = 1 << 14;
  DistinctSet set(kMost);
  for (std::uint64_t value = 1; value <= 1000000; ++value) {
    set.insert(value);
    set.insert(value / 2 + 1);
  }
  EXPECT_FALSE(set.count().exact);
  EXPECT_NEAR(double(set.count().count), 1e6, 5 * 1.2 / std::sqrt(double(kMost)) * 1e6);
}

TEST(DistinctSet, OfOneValueStillCounts) {
  DistinctSet set(1);
  for (std::uint64_t value = 1; value <= 100; ++value)
    set.insert(value);
  EXPECT_FALSE(set.count().exact);
}

TEST(WordTally, EntropyIsThatOfShares) {
  WordTally counts(100);
  EXPECT_EQ(counts.entropy(), 0);
  EXPECT_TRUE(counts.add(5, 4));
  EXPECT_EQ(counts.entropy(), 0);
  EXPECT_TRUE(counts.add(0xffffffff, 2));
  EXPECT_FALSE(counts.add(0xffffffff, 1));
  EXPECT_TRUE(counts.add(7, 1));
  EXPECT_NEAR(counts.entropy(), 4.0 / 8 * 1 + 3.0 / 8 * std::log2(8.0 / 3) + 1.0 / 8 * 3, 1e-12);
  EXPECT_TRUE(counts.exact());
}

TEST(WordTally, GroupsGiveALowerBound) {
  constexpr std::uint32_t kWords = 100000;
  WordTally all(kWords);
  WordTally some(1 << 12);
  for (std::uint32_t word = 1; word <= kWords; ++word) {
    const std::uint64_t times = word == 1000 ? kWords : 1;
    all.add(word, times);
    some.add(word, times);
  }
  EXPECT_TRUE(all.exact());
  EXPECT_FALSE(some.exact());
  // One word has half of all: what is left is the entropy of a coin and half that of the others.
  EXPECT_NEAR(all.entropy(), 1 + std::log2(double(kWords)) / 2, 1e-3);
  EXPECT_LT(some.entropy(), all.entropy());
  EXPECT_GT(some.entropy(), 1 + 12 / 2.0 - 0.1);
}

} // namespace
} // namespace voxc::test
