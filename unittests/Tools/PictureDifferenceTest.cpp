// What pictures say about each other.
#include "common/PictureDifference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace voxc::tool {
namespace {

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
