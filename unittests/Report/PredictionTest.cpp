// How well predictions came true, what charts have in common, and figures as CSV.
#include "MakeCell.h"

#include "report/ChartRanges.h"
#include "report/Csv.h"
#include "report/Prediction.h"

#include <gmock/gmock.h>

namespace voxc::report {
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

/// Cells of which each was foretold so fast and is so fast.
std::vector<Cell> foretold(const std::vector<std::pair<double, double>> &speeds) {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    cells.push_back(makeCell("G(11)", 100 + i, speeds[i].second));
    cells.back().predicted.emplace().mraysPerS = speeds[i].first;
  }
  return cells;
}

struct Quality {
  double error;
  std::optional<double> order;
};

Quality qualityOf(const std::vector<Cell> &cells) {
  const Catalogue catalogue = makeCatalogue(cells);
  const auto predictions = predictionsOf(catalogue, catalogue.stages.at(0));
  return {medianError(predictions), rankCorrelation(predictions)};
}

TEST(Prediction, HasTheMedianError) {
  EXPECT_DOUBLE_EQ(qualityOf(foretold({{1.5, 1}, {1, 1}, {3, 4}})).error, 0.25);
  EXPECT_DOUBLE_EQ(qualityOf(foretold({{1.5, 1}, {3, 4}})).error, 0.375);
  EXPECT_EQ(qualityOf({makeCell("G(11)", 1, 1)}).error, 0);
}

TEST(Prediction, HasSpearmansCorrelation) {
  EXPECT_DOUBLE_EQ(*qualityOf(foretold({{1, 10}, {2, 11}, {9, 50}})).order, 1);
  EXPECT_DOUBLE_EQ(*qualityOf(foretold({{1, 3}, {2, 2}, {3, 1}})).order, -1);
  EXPECT_DOUBLE_EQ(*qualityOf(foretold({{1, 1}, {2, 3}, {3, 2}, {4, 4}})).order, 0.8);
  // Equal ones share their mean rank: (1, 2.5, 2.5, 4) with (1, 2, 3, 4).
  EXPECT_NEAR(*qualityOf(foretold({{1, 1}, {2, 2}, {2, 3}, {4, 4}})).order, 4.5 / std::sqrt(4.5 * 5), 1e-12);
  EXPECT_FALSE(qualityOf(foretold({{1, 1}, {1, 2}})).order);
}

TEST(Prediction, ComparesWords) {
  std::vector<Cell> cells = foretold({{1, 1}, {1, 1}, {1, 1}});
  cells[0].volume.words = cells[0].predicted->words = 7;
  cells[1].volume.words = 10, cells[1].predicted->words = 12;
  const Catalogue catalogue = makeCatalogue(cells);
  const WordPredictions words = wordPredictionsOf(catalogue, catalogue.stages.at(0));
  EXPECT_EQ(words.all, 2u);
  EXPECT_EQ(words.exact, 1u);
  EXPECT_EQ(words.worst, 2u);
}

TEST(ChartRanges, AreSharedByChartsThatAreCompared) {
  std::vector<Cell> cells = {makeCell("G(11)", 100, 2), makeCell("G(11)", 900, 5), makeCell("G(11)", 50, 0.2),
                             makeCell("G(11)", 60, 7), makeCell("G(11)", 5, 3)};
  cells[1].device.name = "cpu";
  cells[2].device.name = "slow";
  cells[3].device.clock = "gpu";
  cells[3].speed.mraysPerDeviceS = makeSpeed(700, 0);
  cells[4].resolution = 512;
  const Catalogue catalogue = makeCatalogue(cells);
  const std::vector<ChartRange> ranges = chartRanges(catalogue);
  ASSERT_THAT(ranges, SizeIs(5));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(ranges[i].leastBytes, 50);
    EXPECT_EQ(ranges[i].mostBytes, 900);
  }
  const auto speedOf = [&](const std::string &device, bool hasClock) {
    for (std::size_t i = 0; i < 4; ++i)
      if (catalogue.stages[i].device.starts_with(device) && catalogue.stages[i].hasClock == hasClock)
        return ranges[i].mostSpeed;
    return 0.0;
  };
  EXPECT_DOUBLE_EQ(speedOf("llvmpipe", false), speedOf("cpu", false));
  EXPECT_LT(speedOf("slow", false), 0.3); // It would lie flat on the others' axis.
  EXPECT_DOUBLE_EQ(speedOf("llvmpipe", true), 700);
  EXPECT_EQ(ranges[4].mostBytes, 5);
}

TEST(Csv, HasALineForEachCell) {
  std::vector<Cell> cells = {makeCell("R(4^3) G(7)", 100, 0.1, {"a", "b"}),
                             makeFailure("G(99)", "say \"no\"\nor yes")};
  const std::string csv = toCsv(makeCatalogue(cells));
  EXPECT_THAT(csv, StartsWith("model,input,resolution,"));
  EXPECT_THAT(
      csv,
      HasSubstr("\r\nhut,,2048,front,100,auto,,llvmpipe,cpu,exact,R(4^3) G(7),\"a, b\",,measured,on,100,"));
  EXPECT_THAT(csv, HasSubstr(",0.1,0.099,0.101,"));
  EXPECT_THAT(csv, HasSubstr(",failed,,,"));
  EXPECT_THAT(csv, HasSubstr(",\"say \"\"no\"\"\nor yes\","));
}

} // namespace
} // namespace voxc::report
