// What repeats and pictures say about each other.
#include "common/PictureDifference.h"
#include "common/Repeats.h"

#include <gtest/gtest.h>

#include <cmath>

namespace voxc::tool {
namespace {

TEST(Repeats, HaveAMedianAndASpread) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
  EXPECT_EQ(median({}), 0);
  EXPECT_DOUBLE_EQ(spread({0.9, 1, 1.1}), 0.2);
  EXPECT_EQ(repeatsJson({}), nullptr);
  EXPECT_EQ(repeatsJson({2, 1, 4})["median"], 2);
}

TEST(Repeats, OfTheSameWorkAreEqualWithinTheSpread) {
  EXPECT_TRUE(areEqual({1.00, 1.03, 0.99}, {1.01, 0.98, 1.02}));
  EXPECT_TRUE(areEqual({1, 1, 1}, {1, 1, 1}));
  EXPECT_FALSE(areEqual({1.00, 1.01, 1.00}, {1.10, 1.11, 1.10}));
  EXPECT_FALSE(areEqual({1.10, 1.11, 1.10}, {1.00, 1.01, 1.00}));
}

Picture filled(std::uint32_t pixel) { return {2, 2, std::vector<std::uint32_t>(4, pixel)}; }

TEST(PictureDifference, CountsChannelsNotAlpha) {
  const Picture grey = filled(0xff808080u);
  EXPECT_TRUE(std::isinf(difference(grey, filled(0x00808080u)).psnr));
  Picture other = grey;
  other.pixels[3] = 0xff808a7fu;
  const PictureDifference found = difference(grey, other);
  EXPECT_EQ(found.worst, 10);
  EXPECT_DOUBLE_EQ(found.changed, 0.25);
  EXPECT_NEAR(found.psnr, 10 * std::log10(255.0 * 255 * 12 / 101), 1e-9);
  EXPECT_NEAR(difference(filled(0), filled(0xffffffu)).psnr, 0, 1e-9);
}

} // namespace
} // namespace voxc::tool
