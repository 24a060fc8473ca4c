// Which payload is tried first, for scenes of few and many colours.
#include "voxc/Facts/PayloadChoice.h"

#include <gtest/gtest.h>

namespace voxc {
namespace {

Facts factsOf(std::uint64_t voxels, std::uint64_t colours, bool exact = true) {
  Facts facts;
  facts.voxels = voxels;
  facts.colours.words = {colours, exact};
  return facts;
}

std::string firstOf(const Facts &facts) { return choosePayload(facts).front().payload; }

TEST(PayloadChoice, FollowsTheColours) {
  EXPECT_EQ(firstOf(factsOf(1000, 1)), "constant");
  EXPECT_EQ(firstOf(factsOf(1000, 2)), "palette(1)");
  EXPECT_EQ(firstOf(factsOf(1000, 40)), "palette(6)");
  EXPECT_EQ(firstOf(factsOf(10'000'000, 65536)), "palette(16)");
  EXPECT_EQ(firstOf(factsOf(10'000'000, 65537)), "rgba8");
}

TEST(PayloadChoice, DoesNotTrustAnEstimate) {
  EXPECT_EQ(firstOf(factsOf(100'000'000, 50000, false)), "rgba8");
}

TEST(PayloadChoice, LeavesColoursThatHardlyComeAgain) {
  EXPECT_EQ(firstOf(factsOf(1600, 100)), "palette(7)");
  EXPECT_EQ(firstOf(factsOf(1599, 100)), "rgba8");
}

TEST(PayloadChoice, EndsWithWhatSuitsEveryFormat) {
  for (const Facts &facts : {factsOf(0, 0), factsOf(1000, 1), factsOf(1000, 7), factsOf(1000, 999)}) {
    const auto choices = choosePayload(facts);
    EXPECT_EQ(choices.back().payload, "rgba8");
    EXPECT_FALSE(choices.back().apart);
  }
}

} // namespace
} // namespace voxc
