// The graph of a scene: what is equal, what is counted, and what it refuses.
#include "voxc/Search/SceneDag.h"

#include "voxc/Source/Sources.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>

namespace voxc {
namespace {

SceneDag dagOf(VoxelSource &source, SceneDag::Options options = {}) {
  auto dag = SceneDag::build(source, options);
  EXPECT_TRUE(dag) << dag.error().message;
  return std::move(*dag);
}

std::uint64_t cubes(const SceneDag &dag, int height) {
  const auto occurrences = dag.occurrences(height);
  return std::accumulate(occurrences.begin(), occurrences.end(), std::uint64_t{0});
}

TEST(SceneDag, AFullCubeIsOneNodeAHeight) {
  const SceneDag dag = dagOf(**makeBuiltinSource("full", 32));
  EXPECT_EQ(dag.log2Side(), 5);
  for (int height = 0; height <= 5; ++height) {
    EXPECT_EQ(dag.count(height), 1u);
    EXPECT_EQ(cubes(dag, height), std::uint64_t{1} << 3 * (5 - height));
  }
  EXPECT_EQ(dag.node(3, 0).mask, 255u);
}

TEST(SceneDag, ColoursMakeCubesDiffer) {
  auto source = *makeBuiltinSource("terrain", 64);
  const SceneDag colours = dagOf(*source, {.detail = SceneDag::Detail::Colours});
  const SceneDag shape = dagOf(*source);
  EXPECT_EQ(shape.count(0), 1u);
  EXPECT_GT(colours.count(0), 10u);
  for (int height = 1; height <= 6; ++height) {
    EXPECT_GE(colours.count(height), shape.count(height));
    EXPECT_EQ(cubes(colours, height), cubes(shape, height));
  }
}

TEST(SceneDag, ItsShapeIsThatOfTheSceneWithoutColours) {
  for (const char *scene : {"terrain", "shell", "empty", "checker"}) {
    auto source = *makeBuiltinSource(scene, 32);
    const SceneDag shape = dagOf(*source);
    const SceneDag without = dagOf(*source, {.detail = SceneDag::Detail::Colours}).shape();
    ASSERT_EQ(without.log2Side(), shape.log2Side());
    EXPECT_EQ(without.isEmpty(), shape.isEmpty());
    for (int height = 0; height <= shape.log2Side(); ++height) {
      EXPECT_EQ(without.count(height), shape.count(height)) << scene << " at " << height;
      EXPECT_EQ(cubes(without, height), cubes(shape, height)) << scene << " at " << height;
    }
  }
}

TEST(SceneDag, NothingIsEmpty) {
  const SceneDag dag = dagOf(**makeBuiltinSource("empty", 16));
  EXPECT_TRUE(dag.isEmpty());
  EXPECT_EQ(dag.log2Side(), 4);
  EXPECT_EQ(cubes(dag, 4), 0u);
}

TEST(SceneDag, ItIsAsLargeAsAsked) {
  const SceneDag dag = dagOf(**makeBuiltinSource("voxel", 4), {.log2Side = 9});
  EXPECT_EQ(dag.log2Side(), 9);
  EXPECT_EQ(dag.count(9), 1u);
  EXPECT_EQ(dag.node(9, 0).children.size(), 1u);
}

TEST(SceneDag, BricksAreLookedAtOnce) {
  std::uint64_t voxels = 0;
  const SceneDag dag =
      dagOf(**makeBuiltinSource("terrain", 32), {.look = [&](std::span<const std::uint32_t> cells) {
        for (const std::uint32_t cell : cells)
          voxels += cell != 0;
      }});
  EXPECT_EQ(voxels, cubes(dag, 0));
}

TEST(SceneDag, TooManyCubesAreToldWithTheirBound) {
  const auto dag = SceneDag::build(**makeBuiltinSource("dust", 64), {.mostNodes = 100});
  ASSERT_FALSE(dag);
  EXPECT_EQ(dag.error().kind, ErrorKind::Environment);
  EXPECT_NE(dag.error().message.find("more than 100 different cubes"), std::string::npos)
      << dag.error().message;
}

TEST(SceneDag, StopsWhenAsked) {
  const std::atomic<bool> stop = true;
  const auto dag = SceneDag::build(**makeBuiltinSource("terrain", 64), {}, {.stop = &stop});
  ASSERT_FALSE(dag);
  EXPECT_EQ(dag.error().kind, ErrorKind::Interrupted);
}

} // namespace
} // namespace voxc
