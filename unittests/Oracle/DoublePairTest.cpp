// Differences and products that doubles cannot hold, and what is said of them.
#include "../../lib/Oracle/DoublePair.h"

#include <gtest/gtest.h>

namespace voxc::test {
namespace {

TEST(DoublePair, ADifferenceThatIsNoDoubleIsNone) {
  EXPECT_EQ(exactDifference(3, 0.25), 2.75);
  EXPECT_EQ(exactDifference(1, 0x1p-52), 1 - 0x1p-52);
  EXPECT_EQ(exactDifference(1, 0x1p-60), std::nullopt);
  EXPECT_EQ(exactDifference(0x1p-60, 1), std::nullopt);
}

TEST(DoublePair, ProductsThatRoundAlikeHaveTheirOrder) {
  const double wide = 1 + 0x1p-52, narrow = 1 + 0x1p-23;
  const DoublePair more = exactProduct(wide, narrow);
  const DoublePair less = {more.high, 0}; // Without the 2^-75 that one double has no room for.
  EXPECT_GT(order(more, less), 0);
  EXPECT_LT(order(less, more), 0);
  EXPECT_EQ(order(more, exactProduct(wide, narrow)), 0);
  EXPECT_LT(order(exactProduct(2, 3), exactProduct(7, 1)), 0);
}

} // namespace
} // namespace voxc::test
