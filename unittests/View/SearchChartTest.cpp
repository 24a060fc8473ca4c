// What a search measured, as points that can be clicked; and formats in a line.
#include "view/SearchChart.h"
#include "view/FormatText.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace voxc::view {
namespace {

using measure::Record;
using ::testing::ElementsAre;

Record record(const std::string &format, std::uint64_t bytes, double mraysPerS, const std::string &set = "a",
              std::vector<std::string> passes = {}) {
  Record result;
  result.model.name = "hut";
  result.model.digest = "1";
  result.format.name = format;
  result.format.passes = std::move(passes);
  result.precision = "exact";
  result.device = {"cpu", "cpu", "", 2, "cpu"};
  result.rays.digest = set;
  result.volume.bytes = bytes;
  result.speed.mraysPerCpuS = measure::Speed{mraysPerS, mraysPerS, mraysPerS, 0};
  return result;
}

TEST(SearchPoints, AreSortedAndKnowTheFrontier) {
  const SearchPoints search = makeSearchPoints(std::vector{record("G(5)", 300, 5), record("S(5)", 100, 2),
                                                           record("R(5^3)", 200, 1), record("G(6)", 400, 9)});
  ASSERT_EQ(search.points.size(), 4u);
  std::vector<double> bytes;
  std::vector<bool> leads;
  for (const SearchPoint &point : search.points) {
    bytes.push_back(point.bytes);
    leads.push_back(point.isLeading);
  }
  EXPECT_THAT(bytes, ElementsAre(100, 200, 300, 400));
  EXPECT_THAT(leads, ElementsAre(true, false, true, true));
  EXPECT_EQ(search.points[1].text, "R(5, 5, 5)");
  EXPECT_EQ(search.device, "cpu");
  EXPECT_EQ(search.model, "hut");
}

TEST(SearchPoints, LeadByThemselvesWhereOthersAreAsSmallOrAsFast) {
  const SearchPoints search =
      makeSearchPoints(std::vector{record("G(5)", 100, 2), record("S(5)", 100, 1), record("R(5^3)", 100, 2),
                                   record("G(6)", 300, 2), record("S(6)", 400, 3), record("R(6^3)", 500, 3)});
  std::map<std::string, bool> leads;
  for (const SearchPoint &point : search.points)
    leads[point.text] = point.isLeading;
  EXPECT_EQ(leads, (std::map<std::string, bool>{{"G(5)", true},
                                                {"S(5)", false},
                                                {"R(5, 5, 5)", true},
                                                {"G(6)", false},
                                                {"S(6)", true},
                                                {"R(6, 6, 6)", false}}));
}

TEST(SearchPoints, TakeTheMeanTimeOverAllSetsOfRays) {
  const SearchPoints search = makeSearchPoints(
      std::vector{record("G(5)", 300, 4, "a"), record("G(5)", 300, 12, "b"), record("S(5)", 100, 2, "a")});
  // 1/4 and 1/12 of a second for a million rays; S(5) lacks a set.
  ASSERT_EQ(search.points.size(), 1u);
  EXPECT_DOUBLE_EQ(search.points[0].mraysPerS, 6);
}

TEST(SearchPoints, LeaveOutFailuresAndWhatCannotBeCompared) {
  Record failed = record("G(7)", 100, 1), other = record("G(8)", 100, 1), fast = record("G(9)", 100, 1);
  failed.failure = measure::Failure{"build", "no", {}};
  other.device.name = "llvmpipe";
  fast.precision = "fast";
  const SearchPoints search = makeSearchPoints(std::vector{failed, record("G(5)", 300, 5), other, fast});
  ASSERT_EQ(search.points.size(), 1u);
  EXPECT_EQ(search.points[0].text, "G(5)");
  EXPECT_TRUE(makeSearchPoints(std::vector{failed}).points.empty());
}

TEST(SearchPoints, AreFoundByTheirFormatAndPasses) {
  const SearchPoints search = makeSearchPoints(
      std::vector{record("G(5)", 100, 1), record("G(5)", 90, 0.5, "a", {"whole-level-dedup", "palette=4"})});
  EXPECT_EQ(search.find("G(5) --whole-level-dedup --palette=4"), 0u);
  EXPECT_EQ(search.find("G(5)"), 1u);
  EXPECT_FALSE(search.find("G(4)"));
}

TEST(SearchPoints, TheNextOneLeads) {
  const SearchPoints search =
      makeSearchPoints(std::vector{record("S(5)", 100, 2), record("R(5^3)", 200, 1), record("G(5)", 300, 5)});
  EXPECT_EQ(search.nextLeading({}, 1), 0u);
  EXPECT_EQ(search.nextLeading({}, -1), 2u);
  EXPECT_EQ(search.nextLeading(0, 1), 2u);
  EXPECT_EQ(search.nextLeading(1, -1), 0u);
  EXPECT_FALSE(search.nextLeading(2, 1));
}

TEST(SearchChart, PlacesSizesToTheRightAndSpeedsUpwards) {
  const SearchPoints search = makeSearchPoints(
      std::vector{record("S(5)", 1024, 2), record("R(5^3)", 2048, 1), record("G(5)", 4096, 4)});
  const SearchChart chart(search, 300, 100);
  const auto &places = chart.places();
  ASSERT_EQ(places.size(), 3u);
  // Equal ratios are equally far apart, and twice the speed is twice as high.
  EXPECT_NEAR(places[1].x - places[0].x, places[2].x - places[1].x, 1e-6);
  EXPECT_GT(places[1].x, places[0].x);
  EXPECT_NEAR(100 - places[2].y, 2 * (100 - places[0].y), 1e-6);
  for (const glm::dvec2 &place : places) {
    EXPECT_TRUE(place.x >= 0 && place.x <= 300);
    EXPECT_TRUE(place.y >= 0 && place.y <= 100);
  }
  EXPECT_EQ(chart.frontier().size(), 5u);
}

TEST(SearchChart, AClickTakesTheNearestPoint) {
  const SearchPoints search = makeSearchPoints(std::vector{record("S(5)", 1024, 2), record("G(5)", 4096, 4)});
  const SearchChart chart(search, 300, 100);
  EXPECT_EQ(chart.nearest(chart.places()[1] + glm::dvec2(3, -2), 8), 1u);
  EXPECT_EQ(chart.nearest(chart.places()[0] + glm::dvec2(-5, 0), 8), 0u);
  EXPECT_FALSE(chart.nearest(chart.places()[0] + glm::dvec2(-9, 0), 8));
}

TEST(SearchChart, OfTwoPointsInReachTheNearerIsTaken) {
  const SearchPoints search = makeSearchPoints(
      std::vector{record("S(5)", 1000, 4), record("G(5)", 1010, 4), record("G(6)", 100000, 4)});
  const SearchChart chart(search, 300, 100);
  for (const std::size_t i : {0u, 1u})
    EXPECT_EQ(chart.nearest(chart.places()[i], 50), i);
}

TEST(FormatText, PartsPassesFromTheFormat) {
  const FormatText text = parseFormatText("  'R(4,4,4) G(5)' --whole-level-dedup  --palette=4 ");
  EXPECT_EQ(text.format, "R(4,4,4) G(5)");
  EXPECT_THAT(text.passes, ElementsAre("whole-level-dedup", "palette=4"));
  EXPECT_EQ(formatText(text.format, text.passes), "R(4,4,4) G(5) --whole-level-dedup --palette=4");
  EXPECT_EQ(parseFormatText("G(5)").passes.size(), 0u);
  EXPECT_EQ(parseFormatText("").format, "");
}

TEST(FormatText, IsTheSameForWhatMeansTheSame) {
  EXPECT_EQ(spelledText("R(4^3)  G(5) --flat-traversal"), spelledText("R(4, 4, 4) G(5)   --flat-traversal"));
  EXPECT_EQ(spelledText("no format"), "no format");
}

TEST(FormatText, GivesAFormatWithItsAttributesAgain) {
  const Format plain = *parseFormat("R(2,2,2) G(3)");
  EXPECT_EQ(formatText(plain), "R(2, 2, 2) G(3)");
  for (const char *text :
       {"R(2, 2, 2) G(3) --whole-level-dedup", "R(2, 2, 2) G(3) --whole-level-dedup --inline-leaves",
        "M(1, 1, 1) M(2, 2, 2) M(2, 2, 2) --share-grids --values-apart --short-pointers=12 --octant-counts",
        "M(1, 1, 1) M(2, 2, 2) M(2, 2, 2) --share-grids --palette=5", "G(5) --material=3 --values-apart",
        "D(2, 2, 2, 15) M(2, 2, 2) --octant-distances --df-packing", "R(1, 1, 1) G(4) --granules --granules",
        "S(4) --restart-sv"}) {
    const Format passed = *readFormatText(parseFormatText(text));
    EXPECT_EQ(formatText(passed), text);
  }
}

TEST(FormatText, IsIrInOneLineWhereNoPassesGiveAFormat) {
  const Format format = *parseFormat("format precision=fast { level 1: raw(2, 2, 2) level 2: svdag(3) }");
  const std::string line = formatText(format);
  EXPECT_EQ(line, "format precision=fast { level 1: raw(2, 2, 2) level 2: svdag(3) }");
  EXPECT_EQ(*readFormatText(parseFormatText(line)), format);
}

TEST(FormatText, TellsWhatIsWrong) {
  EXPECT_THAT(readFormatText(parseFormatText("G(")).error().message, ::testing::HasSubstr("error"));
  EXPECT_THAT(readFormatText(parseFormatText("G(4) --nonsense")).error().message,
              ::testing::HasSubstr("'nonsense' is no pass"));
}

std::vector<std::string> texts(const Scale &scale) {
  std::vector<std::string> result;
  for (const Tick &tick : scale.ticks())
    result.push_back(tick.text);
  return result;
}

TEST(Scale, GoesFromZeroInRoundSteps) {
  const Scale scale = Scale::linear({0.3, 0.9}, 0, 100, 5);
  EXPECT_THAT(texts(scale), ElementsAre("0", "0.2", "0.4", "0.6", "0.8", "1"));
  EXPECT_DOUBLE_EQ(scale.place(0.5), 50);
  EXPECT_THAT(texts(Scale::linear({}, 0, 1, 2)), ElementsAre("0", "0.5", "1"));
}

TEST(Scale, CountsBytesInPowersOfTwo) {
  const Scale scale = Scale::bytes({3000, 16384}, 0, 100, 4);
  EXPECT_THAT(texts(scale), ElementsAre("2 KiB", "4 KiB", "8 KiB", "16 KiB"));
  EXPECT_DOUBLE_EQ(scale.place(2048), 0);
  EXPECT_DOUBLE_EQ(scale.place(16384), 100);
  EXPECT_THAT(texts(Scale::bytes({1}, 0, 1, 4)), ElementsAre("1 B", "2 B"));
}

} // namespace
} // namespace voxc::view
