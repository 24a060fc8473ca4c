// Open edges: what evens out on lines, and loops that close what is left.
#include "Mesh/Solid/RimLoops.h"
#include "Mesh/Solid/RimLines.h"
#include "TestLength.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace voxc {
namespace {

using Chain = std::map<std::pair<Point64, Point64>, std::int64_t>; ///< How often edges are passed, all told.

RimEdge rimOf(Point64 from, Point64 to) {
  const std::int64_t times = to < from ? -1 : 1;
  if (times < 0)
    std::swap(from, to);
  const auto point = [](const Point64 &p) { return glm::dvec3(double(p[0]), double(p[1]), double(p[2])); };
  return {{from, to}, {point(from), point(to)}, times, 0};
}

void pass(Chain &chain, const Point64 &from, const Point64 &to, std::int64_t times) {
  const bool isUp = from < to;
  auto &sum = chain[isUp ? std::pair(from, to) : std::pair(to, from)];
  sum += isUp ? times : -times;
  if (sum == 0)
    chain.erase(isUp ? std::pair(from, to) : std::pair(to, from));
}

Chain chainOf(const std::vector<RimEdge> &rims) {
  Chain chain;
  for (const RimEdge &rim : rims)
    pass(chain, rim.ends[0], rim.ends[1], rim.times);
  return chain;
}

Point64 gridPoint(const glm::dvec3 &point) {
  return {std::int64_t(point.x), std::int64_t(point.y), std::int64_t(point.z)};
}

/// Each rim once, with how often it is passed.
std::vector<RimEdge> summed(const std::vector<RimEdge> &rims) {
  std::vector<RimEdge> sums;
  for (const auto &[ends, times] : chainOf(rims)) {
    sums.push_back(rimOf(ends.first, ends.second));
    sums.back().times = times;
  }
  return sums;
}

TEST(RimLines, PartsOfAnEdgeEvenOutWithTheWhole) {
  const Point64 a{0, 0, 0};
  const Point64 b{3, 6, -9};
  const Point64 c{4, 8, -12};
  EXPECT_TRUE(joinedOnLines({rimOf(a, c), rimOf(c, b), rimOf(b, a)}).empty());
  // Beside the line, and passed the same way, they do not.
  EXPECT_EQ(joinedOnLines({rimOf(a, c), rimOf(c, {3, 6, -8}), rimOf({3, 6, -8}, a)}).size(), 3u);
  const auto both = joinedOnLines({rimOf(a, c), rimOf(a, b)});
  EXPECT_EQ(chainOf(both), (Chain{{{a, b}, 2}, {{b, c}, 1}}));
  // On another line of the same direction, nothing meets.
  EXPECT_EQ(joinedOnLines({rimOf(a, c), rimOf({4, 8, -11}, {0, 0, 1})}).size(), 2u);
}

TEST(RimLines, OnOneLineIsWhatSumsOfUnitsAre) {
  std::mt19937 random(1);
  for (int round = 0; round < test::rounds(50); ++round) {
    std::vector<RimEdge> rims;
    Chain units;
    for (int i = 0; i < 12; ++i) {
      const std::int64_t line = random() % 2;
      const auto at = [line](std::int64_t t) { return Point64{t, 2 * t + line, -t}; };
      const std::int64_t from = random() % 20;
      const std::int64_t to = (from + 1 + random() % 19) % 20;
      rims.push_back(rimOf(at(from), at(to)));
      const std::int64_t step = from < to ? 1 : -1;
      for (std::int64_t t = from; t != to; t += step)
        pass(units, at(t), at(t + step), 1);
    }
    Chain joined;
    for (const RimEdge &rim : joinedOnLines(rims)) {
      const Point64 &low = rim.ends[0];
      for (std::int64_t t = 0; t < rim.ends[1][0] - low[0]; ++t) {
        const auto at = [&](std::int64_t i) { return Point64{low[0] + i, low[1] + 2 * i, low[2] - i}; };
        EXPECT_FALSE(joined.contains({at(t), at(t + 1)})) << "a piece comes twice";
        pass(joined, at(t), at(t + 1), rim.times);
      }
    }
    ASSERT_EQ(joined, units);
  }
}

TEST(RimLoops, AddUpToTheRimsAndPassNoCornerTwice) {
  std::mt19937 random(2);
  for (int round = 0; round < test::rounds(50); ++round)
    for (const bool isEither : {false, true}) {
      // Closed walks over few corners.
      std::vector<RimEdge> rims;
      const auto corner = [&] { return Point64{std::int64_t(random() % 3), std::int64_t(random() % 3), 0}; };
      for (int walk = 0; walk < 4; ++walk) {
        const Point64 first = corner();
        Point64 at = first;
        for (int i = 0; i < 6; ++i) {
          const Point64 next = i == 5 ? first : corner();
          if (next != at)
            rims.push_back(rimOf(at, next));
          at = next;
        }
      }
      rims = summed(rims);
      Chain walked;
      for (const auto &loop : loopsOf(rims, isEither)) {
        std::map<Point64, int> visits;
        for (std::size_t i = 0; i < loop.size(); ++i) {
          EXPECT_EQ(loop[i].to, loop[(i + 1) % loop.size()].from);
          EXPECT_EQ(visits[gridPoint(loop[i].from)]++, 0);
          if (isEither)
            EXPECT_TRUE(
                walked.emplace(std::minmax(gridPoint(loop[i].from), gridPoint(loop[i].to)), 1).second);
          else
            pass(walked, gridPoint(loop[i].from), gridPoint(loop[i].to), 1);
        }
      }
      Chain expected = chainOf(rims);
      if (isEither)
        std::erase_if(expected, [](const auto &edge) { return edge.second % 2 == 0; });
      for (auto &[ends, times] : expected)
        times = isEither ? 1 : times;
      ASSERT_EQ(walked, expected);
    }
}

TEST(RimLoops, CracksAreLoopsOfTheirOwn) {
  // Long edges one behind the other, each beside two short ones that go back: from both ends of all.
  std::vector<RimEdge> rims;
  for (std::int64_t i = 0; i < 50; ++i) {
    rims.push_back(rimOf({10 * i, 0, 0}, {10 * i + 10, 0, 0}));
    rims.push_back(rimOf({10 * i + 10, 0, 0}, {10 * i + 5, 1, 0}));
    rims.push_back(rimOf({10 * i + 5, 1, 0}, {10 * i, 0, 0}));
  }
  for (const bool isEither : {false, true}) {
    const auto loops = loopsOf(rims, isEither);
    EXPECT_EQ(loops.size(), 50u);
    for (const auto &loop : loops)
      EXPECT_EQ(loop.size(), 3u);
  }
}

TEST(RimLoops, OfTooManyOrOfWhatDoesNotCloseAreNone) {
  EXPECT_TRUE(loopsOf(std::vector{rimOf({0, 0, 0}, {1, 0, 0})}, false).empty());
  std::vector<RimEdge> triangle{rimOf({0, 0, 0}, {1, 0, 0}), rimOf({1, 0, 0}, {1, 1, 0}),
                                rimOf({1, 1, 0}, {0, 0, 0})};
  EXPECT_EQ(loopsOf(triangle, false).size(), 1u);
  for (RimEdge &rim : triangle)
    rim.times *= 1 << 20;
  EXPECT_TRUE(loopsOf(triangle, false).empty());
  EXPECT_TRUE(loopsOf({}, false).empty());
  // A star of many petals, all of which meet in one corner.
  std::vector<RimEdge> star;
  for (std::int64_t i = 1; i <= 50000; ++i) {
    star.push_back(rimOf({0, 0, 0}, {i, 1, 0}));
    star.push_back(rimOf({i, 1, 0}, {i, 2, 0}));
    star.push_back(rimOf({i, 2, 0}, {0, 0, 0}));
  }
  EXPECT_EQ(loopsOf(star, false).size(), 50000u);
}

} // namespace
} // namespace voxc
