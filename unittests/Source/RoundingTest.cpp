// Colours in place of others: few that stand for many, and how far they are from them.
#include "voxc/Source/Rounding.h"

#include "voxc/Layout/Rgb565.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

namespace voxc {
namespace {

/// A cube of 16^3 voxels of as many colours as `step` leaves.
std::unique_ptr<VoxelSource> gradient(std::uint32_t step) {
  return makeFunctionSource({16, 16, 16}, [step](Int3 c) {
    const auto channel = [step](int place) { return static_cast<std::uint32_t>(place) * 16 / step * step; };
    return rgba(channel(c.x), channel(c.y), channel(c.z));
  });
}

std::set<std::uint32_t> coloursOf(VoxelSource &source) {
  std::set<std::uint32_t> colours;
  std::array<std::uint32_t, 512> words;
  for (int code = 0; code < 8; ++code) {
    EXPECT_TRUE(source.read({mortonCell(code) * 8, 3}, words.data()));
    colours.insert(words.begin(), words.end());
  }
  return colours;
}

TEST(ReduceColours, KeepsThoseForWhichThereIsRoom) {
  const auto source = gradient(64); // Four steps a channel.
  const auto rounding = reduceColours(*source, 1 << 6);
  ASSERT_TRUE(rounding);
  EXPECT_FALSE(*rounding);
}

TEST(ReduceColours, ChoosesAsManyAsThereMayBe) {
  for (const int log2Colours : {1, 3, 5, 8, 10}) {
    const auto source = gradient(16); // 4096 colours.
    const auto rounding = reduceColours(*source, std::size_t{1} << log2Colours);
    ASSERT_TRUE(rounding);
    RoundedSource rounded(*source, *rounding);
    const auto colours = coloursOf(rounded);
    EXPECT_LE(colours.size(), std::size_t{1} << log2Colours);
    EXPECT_GT(colours.size(), std::size_t{1} << (log2Colours - 1));
    EXPECT_EQ(rounded.error().voxels, 4096u);
  }
}

TEST(ReduceColours, ErrsLessWithMore) {
  double last = 256;
  for (const int log2Colours : {1, 3, 6, 9}) {
    const auto source = gradient(16);
    RoundedSource rounded(*source, *reduceColours(*source, std::size_t{1} << log2Colours));
    coloursOf(rounded);
    const double mean = rounded.error().mean[0] + rounded.error().mean[1] + rounded.error().mean[2];
    EXPECT_LT(mean, last);
    last = mean;
  }
  EXPECT_LT(last, 3 * 16.0);
}

TEST(RoundedSource, MeasuresOverItsViews) {
  const auto source = gradient(16);
  RoundedSource rounded(*source, [](std::uint32_t word) { return word ^ 3; });
  const auto view = rounded.view();
  ASSERT_TRUE(view);
  EXPECT_EQ(coloursOf(*view).size(), 4096u);
  const ColourError error = rounded.error();
  EXPECT_EQ(error.largest, (std::array<int, 4>{3, 0, 0, 0}));
  EXPECT_EQ(error.mean[0], 3.0);
  EXPECT_EQ(error.voxels, 4096u);
}

TEST(Rgb565, IsTheNearestColour) {
  for (std::uint32_t i = 0; i < 256; ++i) {
    const std::uint32_t word = rgba(i, i, i, 7);
    const std::uint32_t kept = ofRgb565(toRgb565(word));
    EXPECT_EQ(kept >> 24, 255u);
    EXPECT_LE(std::abs(static_cast<int>(kept & 255) - static_cast<int>(i)), 4);
    EXPECT_LE(std::abs(static_cast<int>(kept >> 8 & 255) - static_cast<int>(i)), 2);
    EXPECT_LE(std::abs(static_cast<int>(kept >> 16 & 255) - static_cast<int>(i)), 4);
    EXPECT_EQ(ofRgb565(toRgb565(kept)), kept);
  }
}

} // namespace
} // namespace voxc
