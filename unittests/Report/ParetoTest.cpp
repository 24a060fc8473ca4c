// The Pareto frontier, ties included.
#include "MakeCell.h"

#include "report/Pareto.h"

#include "TestLength.h"

#include <gtest/gtest.h>

#include <random>

namespace voxc::report {
namespace {

using Flags = std::vector<bool>;

Flags frontier(const std::vector<SizeSpeed> &points) { return paretoFrontier(points); }

TEST(Pareto, KeepsWhatNothingBeatsInBoth) {
  EXPECT_EQ(frontier({}), Flags());
  EXPECT_EQ(frontier({{1, 1}}), Flags({true}));
  EXPECT_EQ(frontier({{3, 3}, {1, 1}, {2, 0.5}, {2, 2}}), Flags({true, true, false, true}));
}

TEST(Pareto, OfEquallySmallOnesOnlyTheFastest) {
  EXPECT_EQ(frontier({{1, 1}, {1, 2}, {1, 1.5}}), Flags({false, true, false}));
}

TEST(Pareto, OfEquallyFastOnesOnlyTheSmallest) {
  EXPECT_EQ(frontier({{3, 2}, {1, 2}, {2, 2}}), Flags({false, true, false}));
}

TEST(Pareto, EqualPointsShareTheirFate) {
  EXPECT_EQ(frontier({{1, 1}, {1, 1}, {2, 1}, {2, 1}}), Flags({true, true, false, false}));
}

bool beats(const SizeSpeed &a, const SizeSpeed &b) {
  return a.size <= b.size && a.speed >= b.speed && (a.size < b.size || a.speed > b.speed);
}

TEST(Pareto, IsItsDefinition) {
  std::mt19937 random(7);
  for (int round = 0; round < test::rounds(200); ++round) {
    std::vector<SizeSpeed> points(random() % 12);
    for (SizeSpeed &point : points)
      point = {double(1 + random() % 5), double(1 + random() % 5)};
    const Flags found = frontier(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool isBeaten = false;
      for (const SizeSpeed &other : points)
        isBeaten = isBeaten || beats(other, points[i]);
      EXPECT_EQ(found[i], !isBeaten);
    }
  }
}

/// A letter a point: L leads, = is as good, . is beaten.
std::string places(const std::vector<MeasuredPoint> &points) {
  std::string text;
  for (const Standing &standing : standings(points))
    text += standing.place == Place::Leading ? 'L' : standing.place == Place::AsGood ? '=' : '.';
  return text;
}

TEST(Standings, FollowTheMediansWhereRoundsAgree) {
  const auto at = [](double bytes, double speed) { return MeasuredPoint{bytes, makeSpeed(speed, 0.01)}; };
  EXPECT_EQ(places({}), "");
  EXPECT_EQ(places({at(3, 3), at(1, 1), at(2, 0.5), at(2, 2)}), "LL.L");
  EXPECT_EQ(standings(std::vector{at(1, 2), at(5, 1)})[1].rival, 0u);
}

TEST(Standings, DoNotLeadByLessThanTheRoundsDiffer) {
  const MeasuredPoint small{100, makeSpeed(4.53, 0.02)}, large{500, makeSpeed(4.55, 0.02)};
  EXPECT_EQ(places({small, large}), "L.");
  EXPECT_EQ(places({small, {500, makeSpeed(4.7, 0.02)}}), "LL");
}

TEST(Standings, AreAsGoodAtHardlyMoreBytes) {
  const MeasuredPoint leader{1000, makeSpeed(6, 0.04)};
  EXPECT_EQ(places({leader, {1000, makeSpeed(5.9, 0.01)}}), "L=");
  EXPECT_EQ(places({leader, {1010, makeSpeed(6.1, 0.01)}}), "L=");
  EXPECT_EQ(places({leader, {1011, makeSpeed(6.1, 0.01)}}), "L.");
  EXPECT_EQ(places({leader, {1000, makeSpeed(4.5, 0.01)}}), "L.");
}

/// Each is as fast as the one before it, but the last is faster than the first.
TEST(Standings, ReachTheFastestThroughAChainOfEqualOnes) {
  const auto at = [](double bytes, double speed) { return MeasuredPoint{bytes, makeSpeed(speed, 0.1)}; };
  EXPECT_EQ(places({at(10, 1), at(20, 1.08), at(40, 1.16), at(80, 1.22)}), "L.L.");
}

} // namespace
} // namespace voxc::report
