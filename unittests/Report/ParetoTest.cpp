// The Pareto frontier, ties included.
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

} // namespace
} // namespace voxc::report
