// Plots: scales, labels, and the document.
#include "plot/Plot.h"
#include "plot/Labels.h"
#include "plot/Scale.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace voxc::plot {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> texts(const Scale &scale) {
  std::vector<std::string> result;
  for (const Tick &tick : scale.ticks())
    result.push_back(tick.text);
  return result;
}

TEST(Scale, GoesFromZeroInRoundSteps) {
  const Scale scale({"", Spacing::Linear}, {0.3, 0.9}, 0, 100, 5);
  EXPECT_EQ(texts(scale), (std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
  EXPECT_DOUBLE_EQ(scale.place(0.5), 50);
}

TEST(Scale, HasAPlaceForZeroBeforeTheLeastPower) {
  const Scale scale({"", Spacing::Decades, 1}, {0, 300}, 100, 0, 10);
  EXPECT_EQ(texts(scale), (std::vector<std::string>{"0", "1", "10", "100", "10³"}));
  EXPECT_DOUBLE_EQ(scale.place(0), 100);
  EXPECT_LT(scale.place(1), scale.breakPlace());
  EXPECT_NEAR(scale.place(1000), 0, 1e-9);
  EXPECT_EQ(texts(Scale({"", Spacing::Decades, 1}, {20}, 0, 1, 5)).front(), "0");
  EXPECT_EQ(texts(Scale({"", Spacing::Decades}, {0}, 0, 1, 5)), (std::vector<std::string>{"0", "1", "10"}));
  EXPECT_FALSE(std::isfinite(Scale({"", Spacing::Decades}, {1, 10}, 0, 1, 5).breakPlace()));
}

TEST(Scale, CountsInPowersOfTwo) {
  EXPECT_EQ(texts(Scale({"", Spacing::Octaves}, {16, 128}, 0, 1, 9)),
            (std::vector<std::string>{"2⁴", "2⁵", "2⁶", "2⁷"}));
}

TEST(Labels, DoNotCoverEachOtherNorLeaveTheFrame) {
  std::vector<LabelRequest> requests;
  for (int i = 0; i < 6; ++i)
    requests.push_back({"a label of some length", 300.0 + 20 * i, 380});
  const Box frame = {40, 20, 780, 400};
  const auto labels = placeLabels(requests, frame, 15);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double width = textWidth(labels[i].text, 15);
    EXPECT_GE(labels[i].x, frame.left);
    EXPECT_LE(labels[i].x + width, frame.right);
    for (std::size_t other = 0; other < i; ++other)
      EXPECT_TRUE(std::abs(labels[i].baseline - labels[other].baseline) >= 15 ||
                  std::abs(labels[i].x - labels[other].x) >= width)
          << i << " and " << other;
  }
}

TEST(Labels, AreLeftOutWhereThereIsNoRoomBesideTheirPoints) {
  const Box frame = {0, 0, 400, 300};
  const auto names = [&](const std::vector<LabelRequest> &requests, const std::vector<Box> &obstacles) {
    std::string text;
    for (const PlacedLabel &label : placeWhereFree(requests, frame, 12, obstacles)) {
      EXPECT_FALSE(label.hasLeader);
      text += label.text;
    }
    return text;
  };
  EXPECT_EQ(names({{"a", 100, 100}, {"b", 300, 200}}, {}), "ab");
  EXPECT_EQ(names({{"a", 100, 100}, {"b", 300, 200}}, {{50, 50, 150, 150}}), "b");
  EXPECT_EQ(
      names({{"far too long for a frame that is as narrow as this one is, in letters of this size", 5, 5}},
            {}),
      "");
  // Points in a pile: the four places about them are soon taken.
  EXPECT_LT(names(std::vector<LabelRequest>(9, {"x", 200, 150}), {}).size(), 5u);
}

TEST(Plot, EscapesTextAndLeavesOutWhatIsNotFinite) {
  Plot plot{"a < b & c", "", {"x"}, {"y"}, {{"s", {{1, std::numeric_limits<double>::infinity(), "gone"}}}}};
  plot.series.push_back({"\"t\"", {{1, 2, "<note>"}}});
  const std::string svg = toSvg(plot);
  EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; c"));
  EXPECT_THAT(svg, HasSubstr("&lt;note&gt;"));
  EXPECT_THAT(svg, Not(HasSubstr("gone")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  EXPECT_THAT(svg, HasSubstr("prefers-color-scheme:dark"));
}

} // namespace
} // namespace voxc::plot
