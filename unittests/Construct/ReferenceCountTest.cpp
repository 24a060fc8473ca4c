// How often nodes are shared, as a build tells it.
#include "voxc/Construct/Constructor.h"
#include "voxc/Source/Sources.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voxc {
namespace {

using ::testing::_;
using ::testing::ElementsAre;
using ::testing::Gt;
using ::testing::Le;
using ::testing::Pair;

constexpr std::uint32_t kColour = 0xff0000ffu;

/// A cube full of voxels of one colour, but for its first, whose colour is given.
std::unique_ptr<VoxelSource> cubeWith(int side, std::uint32_t first) {
  std::vector<std::uint32_t> words(static_cast<std::size_t>(side) * side * side, kColour);
  words.front() = first;
  return makeGridSource({side, side, side}, std::move(words));
}

/// For each level, its nodes and how many references more than these lead to them.
std::vector<std::pair<std::uint64_t, std::uint64_t>> countsOf(const char *format, int side,
                                                              std::uint32_t first) {
  std::vector<std::pair<std::uint64_t, std::uint64_t>> counts;
  const auto built = Constructor::compile(*parseFormat(format))->build(*cubeWith(side, first));
  for (const LevelReport &level : built->report.levels)
    counts.emplace_back(level.uniqueNodes, level.sharedNodes);
  return counts;
}

TEST(SharedNodes, OfGridsAreReferencesOfCells) {
  // Seven of eight grids are equal: one is written, and six more references lead to it.
  const char *const shared =
      "format payload=occupancy { level 1: masked(1, 1, 1) level 2: masked(2, 2, 2) share=level }";
  EXPECT_THAT(countsOf(shared, 8, 0), ElementsAre(Pair(1, 0), Pair(2, 6)));
  const char *const apart = "format payload=occupancy { level 1: masked(1, 1, 1) level 2: masked(2, 2, 2) }";
  EXPECT_THAT(countsOf(apart, 8, 0), ElementsAre(Pair(1, 0), Pair(8, 0)));
}

TEST(SharedNodes, OfTreesAreReferencesOfNodesAndCells) {
  // A root, a node of 2^3 voxels, and the words of two colours, to one of which seven children of each node
  // lead.
  constexpr std::uint32_t kOther = 0xff00ff00u;
  EXPECT_THAT(countsOf("G(2)", 4, kOther), ElementsAre(Pair(4, 13)));
  // Below eight cells stand nodes, also where all is of one colour: two of them, and two colours. Eight
  // references lead to the nodes, and eight from each to the colours.
  EXPECT_THAT(countsOf("format { level 1: raw(1, 1, 1) level 2: svdag(1) dedup=level }", 4, kOther),
              ElementsAre(Pair(1, 0), Pair(4, 20)));
  EXPECT_THAT(countsOf("format { level 1: svo(1) level 2: svdag(1) dedup=level }", 4, kOther),
              ElementsAre(Pair(_, 0), Pair(4, 20)));
  EXPECT_THAT(countsOf("format { level 1: svo(1) level 2: svdag(1) dedup=level }", 4, kColour),
              ElementsAre(Pair(_, 0), Pair(2, 14)));
}

TEST(FailedBuilds, TellTheWordsThatTheyReached) {
  const auto constructor = Constructor::compile(*parseFormat("R(2^3) R(2^3)"));
  const auto failed = constructor->build(*cubeWith(16, 1), {.maxWords = 1000});
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.wordsReached(), Gt(500u));
  EXPECT_THAT(failed.wordsReached(), Le(1000u));
  const auto built = constructor->build(*cubeWith(16, 1));
  ASSERT_TRUE(built) << built.error().message;
  EXPECT_EQ(built.wordsReached(), built->volume.words().size());
  EXPECT_EQ(constructor->build(*cubeWith(32, 1)).wordsReached(), 0u) << "it does not fit";
}

} // namespace
} // namespace voxc
