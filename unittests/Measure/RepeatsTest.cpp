// What repeats say.
#include "voxc/Measure/Repeats.h"

#include <gtest/gtest.h>

namespace voxc::measure {
namespace {

TEST(Repeats, HaveAMedianAndASpread) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
  EXPECT_EQ(median({}), 0);
  EXPECT_DOUBLE_EQ(spread({0.9, 1, 1.1}), 0.2);
}

TEST(Repeats, OfTheSameWorkAreEqualWithinTheSpread) {
  EXPECT_TRUE(areEqual(Repeats{1.00, 1.03, 0.99}, Repeats{1.01, 0.98, 1.02}));
  EXPECT_TRUE(areEqual(Repeats{1, 1, 1}, Repeats{1, 1, 1}));
  EXPECT_FALSE(areEqual(Repeats{1.00, 1.01, 1.00}, Repeats{1.10, 1.11, 1.10}));
  EXPECT_FALSE(areEqual(Repeats{1.10, 1.11, 1.10}, Repeats{1.00, 1.01, 1.00}));
}

} // namespace
} // namespace voxc::measure
