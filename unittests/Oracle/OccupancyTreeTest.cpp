// The tree of empty cells: what is empty, and how far around.
#include "../../lib/Oracle/OccupancyTree.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace voxc::test {
namespace {

constexpr std::optional<int> kFull;

TEST(OccupancyTree, WithoutChangesAllIsEmpty) {
  EXPECT_EQ(OccupancyTree().emptyAround({0, 0, 0}), 1);
  EXPECT_EQ(OccupancyTree({}, kMaxLog2Extent).emptyAround({0, 5, (1 << 21) - 1}), 21);
}

TEST(OccupancyTree, EmptyCubesAreThoseOfAnOctree) {
  const std::uint64_t code = mortonCode({5, 6, 7});
  const std::vector<std::uint64_t> changes{code, code + 1};
  const OccupancyTree tree(changes, 4);
  EXPECT_EQ(tree.emptyAround({5, 6, 7}), kFull);
  EXPECT_EQ(tree.emptyAround({4, 6, 7}), 0);
  EXPECT_EQ(tree.emptyAround({6, 5, 7}), 1);
  EXPECT_EQ(tree.emptyAround({1, 1, 1}), 2);
  EXPECT_EQ(tree.emptyAround({15, 1, 9}), 3);
  EXPECT_EQ(tree.emptyAround({16, 0, 0}), 4); // Beyond the tree.
}

TEST(OccupancyTree, FullCubesOfAnySizeAreNotEmpty) {
  const std::vector<std::uint64_t> all{0, std::uint64_t{1} << 63};
  const OccupancyTree tree(all, kMaxLog2Extent);
  EXPECT_EQ(tree.emptyAround({0, 0, 0}), kFull);
  EXPECT_EQ(tree.emptyAround({(1 << 21) - 1, 7, 1 << 20}), kFull);
}

TEST(OccupancyTree, LargestExtentIsHeldSparsely) {
  const int last = (1 << kMaxLog2Extent) - 1;
  const std::uint64_t end = std::uint64_t{1} << 63;
  const std::vector<std::uint64_t> changes{0, 1, end - 1, end};
  const OccupancyTree tree(changes, kMaxLog2Extent);
  EXPECT_EQ(tree.emptyAround({0, 0, 0}), kFull);
  EXPECT_EQ(tree.emptyAround({last, last, last}), kFull);
  EXPECT_EQ(tree.emptyAround({last, 0, 0}), 20);
  EXPECT_EQ(tree.emptyAround({last - 1, last, last}), 0);
}

TEST(OccupancyTree, AgreesWithTheChangesOnRandomRuns) {
  std::mt19937 random(5);
  for (int log2Side = 0; log2Side <= 5; ++log2Side) {
    const std::uint64_t cells = std::uint64_t{1} << 3 * log2Side;
    std::vector<bool> full(cells);
    for (std::uint64_t code = 0; code < cells; ++code)
      full[code] = random() % 16 == 0 ? random() % 2 == 0 : code > 0 && full[code - 1];
    std::vector<std::uint64_t> changes;
    for (std::uint64_t code = 0; code <= cells; ++code)
      if ((code < cells && full[code]) != (changes.size() % 2 == 1))
        changes.push_back(code);
    const OccupancyTree tree(changes, log2Side);
    for (std::uint64_t code = 0; code < cells; ++code) {
      const std::optional<int> around = tree.emptyAround(mortonCell(code));
      ASSERT_EQ(around == kFull, full[code]);
      const std::uint64_t size = around ? std::uint64_t{1} << 3 * *around : 0;
      for (std::uint64_t near = code & ~(size - 1); around && near < (code | (size - 1)) && near < cells;
           ++near)
        ASSERT_FALSE(full[near]) << log2Side << ' ' << code << ' ' << near;
    }
  }
}

} // namespace
} // namespace voxc::test
