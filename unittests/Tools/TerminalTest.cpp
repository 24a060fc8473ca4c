// The progress bar as text, on wide and on narrow terminals.
#include "common/Terminal.h"

#include <gtest/gtest.h>

namespace voxc::tool {
namespace {

const Pace kPace{"  12.3 M voxels/s", "  0:42 left"};

TEST(ProgressBar, TellsStagePercentRateAndTime) {
  EXPECT_EQ(barText("build", 1.0 / 3, kPace, 79),
            "build        [##########....................]  33%  12.3 M voxels/s  0:42 left");
  EXPECT_EQ(barText("build", 0, {}, 79), "build        [..............................]   0%");
}

/// The bar becomes shorter, then the rate goes; the percentage and the time stay.
TEST(ProgressBar, KeepsPercentAndTimeOnNarrowTerminals) {
  EXPECT_EQ(barText("build", 0.5, kPace, 60), "build        [######......]  50%  12.3 M voxels/s  0:42 left");
  EXPECT_EQ(barText("build", 0.5, kPace, 39), "build        [####....]  50%  0:42 left");
  EXPECT_EQ(barText("build", 0.5, kPace, 30), "build  50%  0:42 left");
  EXPECT_EQ(barText("measure the frontier", 0.5, kPace, 30), "measure the fr  50%  0:42 left");
  EXPECT_EQ(barText("build", 0.5, kPace, 10), "  50%  0:4");
  for (int columns = 1; columns < 100; ++columns)
    EXPECT_LE(barText("measure the frontier", 0.999, kPace, columns).size(),
              static_cast<std::size_t>(columns));
}

TEST(ProgressBar, TellsTimeWhenItIsNoGuess) {
  EXPECT_EQ(paceOf(0.4, 0.5, 1000, "rays").left, "");
  EXPECT_EQ(paceOf(10, 0.005, 0, "rays").left, "");
  EXPECT_EQ(paceOf(10, 0.25, 20'000'000, "rays").rate, "  2.0 M rays/s");
  EXPECT_EQ(paceOf(10, 0.25, 20'000'000, "rays").left, "  0:30 left");
  EXPECT_EQ(paceOf(10, 1, 0, "").left, "");
}

} // namespace
} // namespace voxc::tool
