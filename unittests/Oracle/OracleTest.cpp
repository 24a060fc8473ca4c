// The oracle on volumes, and the figures of doctored hits.
#include "voxc/Oracle/Oracle.h"
#include "voxc/Oracle/VerifyRays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace voxc::test {
namespace {

constexpr int kSide = 8;

Format formatOf(std::string_view text) {
  Expected<Format> format = parseFormat(text);
  EXPECT_TRUE(format) << text;
  return *std::move(format);
}

/// A grid of 8^3 cells in one raw level: a floor of height 2, and a pillar at (4, 2..5, 4).
Volume floorAndPillar() {
  std::vector<std::uint32_t> words(1 + kSide * kSide * kSide);
  words[0] = 1;
  const auto word = [&](int x, int y, int z) -> std::uint32_t & {
    return words[static_cast<std::size_t>(1 + x + kSide * (y + kSide * z))];
  };
  for (int z = 0; z < kSide; ++z)
    for (int x = 0; x < kSide; ++x)
      for (int y = 0; y < (x == 4 && z == 4 ? 6 : 2); ++y)
        word(x, y, z) = 0xff000000u + static_cast<std::uint32_t>(x + kSide * (y + kSide * z));
  constexpr std::uint64_t kVoxels = 2 * kSide * kSide + 4;
  return Volume({formatOf("R(3,3,3)"), {kSide, kSide, kSide}, {}, kVoxels}, std::move(words));
}

/// A ray, and what a kernel says of it.
struct Claim {
  Ray ray;
  Hit hit;
};

ErrorFigures figuresOf(const Oracle &oracle, std::initializer_list<Claim> claims) {
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  for (const Claim &claim : claims) {
    rays.push_back(claim.ray);
    hits.push_back(claim.hit);
  }
  return compare(oracle, rays, hits);
}

constexpr Hit kMiss{{-1, -1, -1}, 0, 0, 0};
constexpr Ray kDown{{1.5f, 8, 1.5f}, {0, -2, 0}}; // Hits (1, 1, 1) at t = 3.

class OracleFigures : public testing::Test {
protected:
  OracleFigures() : oracle_(*Oracle::of(floorAndPillar())) {}

  Hit hitAt(Int3 voxel, float t) const { return {{voxel.x, voxel.y, voxel.z}, oracle_.voxel(voxel), t, 0}; }

  Oracle oracle_;
};

TEST(Oracle, DecodesWhatTheVolumeHolds) {
  const Volume volume = floorAndPillar();
  const Oracle oracle = *Oracle::of(volume);
  for (int code = 0; code < kSide * kSide * kSide; ++code) {
    const Int3 cell = mortonCell(static_cast<std::uint64_t>(code));
    EXPECT_EQ(oracle.voxel(cell), volume.lookup(cell).value);
  }
  EXPECT_EQ(oracle.voxel({-1, 0, 0}), 0u);
  EXPECT_EQ(oracle.voxel({0, kSide, 0}), 0u);
}

TEST(Oracle, EmptyVolumeIsNeverHit) {
  const Oracle oracle = *Oracle::of(Volume({formatOf("R(9,9,9) G(12)"), {1, 1, 1}}, {0}));
  for (const Ray &ray : verifyRays(Int3{1 << 21, 1 << 21, 1 << 21}, 200, 1))
    EXPECT_FALSE(oracle.trace(ray).isHit());
}

TEST(Oracle, UniformLeavesAreVoxels) {
  // An octree of height 2 whose root has one child, which has eight equal children: a leaf of 2^3 voxels.
  const Oracle oracle = *Oracle::of(Volume({formatOf("S(2)"), {4, 4, 4}, {}, 8}, {3, 7, 0, 1, 0x8080}));
  EXPECT_EQ(oracle.voxel({3, 2, 2}), 7u);
  EXPECT_EQ(oracle.voxel({1, 2, 2}), 0u);
  const Hit hit = oracle.trace({{-1, 2.5f, 3.5f}, {1, 0, 0}});
  EXPECT_EQ(hit.voxel[0], 2);
  EXPECT_EQ(hit.t, 3);
}

TEST_F(OracleFigures, OwnHitsAreClean) {
  const std::vector<Ray> rays = verifyRays(Int3{kSide, kSide, kSide}, 2000, 4);
  std::vector<Hit> hits;
  for (const Ray &ray : rays)
    hits.push_back(oracle_.trace(ray));
  const ErrorFigures figures = compare(oracle_, rays, hits);
  EXPECT_TRUE(figures.clean());
  EXPECT_EQ(figures.rays, 2000u);
  EXPECT_EQ(figures.maxDt, 0);
  EXPECT_EQ(figures.rmsDt, 0);
  EXPECT_EQ(figures.maxUlpDt, 0);
  EXPECT_TRUE(figures.examples.empty());
}

TEST_F(OracleFigures, CountsEachKindOfDifference) {
  const Ray up{{1.5f, 8.5f, 1.5f}, {0, 1, 0}};
  Hit recoloured = hitAt({1, 1, 1}, 3);
  recoloured.rgba ^= 1;
  const ErrorFigures figures = figuresOf(oracle_, {{kDown, hitAt({1, 1, 1}, 3)},
                                                   {kDown, kMiss},
                                                   {up, hitAt({1, 1, 1}, 3)},
                                                   {kDown, hitAt({4, 5, 4}, 3)},
                                                   {up, kMiss},
                                                   {kDown, recoloured}});
  EXPECT_FALSE(figures.clean());
  EXPECT_EQ(figures.rays, 6u);
  EXPECT_EQ(figures.missed, 1u);
  EXPECT_EQ(figures.ghost, 1u);
  EXPECT_EQ(figures.wrong, 1u);
  EXPECT_EQ(figures.colour, 1u);
  EXPECT_EQ(figures.boundary, 0u);
  EXPECT_EQ(figures.examples, (std::vector<std::uint64_t>{1, 2, 3, 5}));
}

TEST_F(OracleFigures, AnswersWhatIsAsked) {
  const Hit closest = oracle_.trace(kDown);
  const auto expectAnswer = [&](const Question &question, const Hit &hit) {
    const Hit answer = oracle_.answer(kDown, question);
    EXPECT_EQ(std::memcmp(&answer, &hit, sizeof hit), 0) << toString(question.query);
    EXPECT_TRUE(compare(oracle_, std::span(&kDown, 1), std::span(&hit, 1), question).clean());
  };
  expectAnswer({}, closest);
  expectAnswer({Query::Any, outputsOf(Query::Any)}, {{0, 0, 0}, 0, 0, 0});
  expectAnswer({Query::Distance, outputsOf(Query::Distance)}, {{0, 0, 0}, 0, closest.t, 0});
  expectAnswer({Query::Occupancy, outputsOf(Query::Occupancy)}, kMiss);
  Hit faced = closest;
  faced.steps = 3; // It falls on y.
  expectAnswer({Query::Closest, {.face = true}}, faced);
}

TEST_F(OracleFigures, ComparesWhatIsAsked) {
  const auto figuresOfDown = [&](const Question &question, const Hit &hit) {
    return compare(oracle_, std::span(&kDown, 1), std::span(&hit, 1), question);
  };
  const Hit nothing = {{0, 0, 0}, 0, 0, 0};
  EXPECT_TRUE(figuresOfDown({Query::Any, outputsOf(Query::Any)}, nothing).clean());
  EXPECT_EQ(figuresOfDown({Query::Any, outputsOf(Query::Any)}, kMiss).missed, 1u);
  EXPECT_EQ(figuresOfDown({Query::Occupancy, outputsOf(Query::Occupancy)}, hitAt({1, 1, 1}, 3)).ghost, 1u);
  EXPECT_GT(figuresOfDown({Query::Distance, outputsOf(Query::Distance)}, nothing).maxUlpDt, 0);
  EXPECT_EQ(figuresOfDown({Query::Closest, {.face = true}}, oracle_.trace(kDown)).wrong, 1u);
}

TEST_F(OracleFigures, KeepsSixteenExamples) {
  const std::vector<Ray> rays(20, kDown);
  const std::vector<Hit> hits(20, kMiss);
  const ErrorFigures figures = compare(oracle_, rays, hits);
  EXPECT_EQ(figures.missed, 20u);
  ASSERT_EQ(figures.examples.size(), 16u);
  EXPECT_EQ(figures.examples.back(), 15u);
}

TEST_F(OracleFigures, DistancesAreInVoxelsAndUlps) {
  const float later = std::nextafter(3.0f, 4.0f);
  const ErrorFigures figures =
      figuresOf(oracle_, {{kDown, hitAt({1, 1, 1}, 3)}, {kDown, hitAt({1, 1, 1}, later)}, {kDown, kMiss}});
  const double ulp = std::ldexp(1.0, -22);
  EXPECT_EQ(figures.maxUlpDt, 1);
  EXPECT_EQ(figures.maxDt, 2 * ulp);
  EXPECT_DOUBLE_EQ(figures.rmsDt, 2 * ulp / std::sqrt(2.0));
  EXPECT_EQ(figures.missed, 1u);
}

TEST_F(OracleFigures, NoNumberIsNoGoodTime) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_GT(figuresOf(oracle_, {{kDown, hitAt({1, 1, 1}, nan)}}).maxDt, 1e38);
}

TEST_F(OracleFigures, InfiniteTimesAgree) {
  const float tiny = std::numeric_limits<float>::denorm_min(),
              infinity = std::numeric_limits<float>::infinity();
  const Ray slow{{1.5f, 8, 1.5f}, {0, -tiny, 0}};
  const ErrorFigures figures = figuresOf(oracle_, {{slow, hitAt({1, 1, 1}, infinity)}});
  EXPECT_TRUE(figures.clean());
  EXPECT_EQ(figures.maxUlpDt, 0);
}

TEST_F(OracleFigures, RoundingExplainsNeighbours) {
  const ErrorFigures figures =
      figuresOf(oracle_, {{kDown, hitAt({2, 2, 1}, 3)}, {kDown, hitAt({3, 1, 1}, 3)}});
  EXPECT_EQ(figures.wrong, 2u);
  EXPECT_EQ(figures.boundary, 1u);
}

TEST_F(OracleFigures, RoundingExplainsAVoxelBarelyMetOrMissed) {
  // Past the pillar's side at x = 5, just within and just beyond it, and well within and beyond.
  const auto past = [](float x) { return Ray{{x, 4.5f, 0.5f}, {0, 0, 1}}; };
  const float within = std::nextafter(5.0f, 0.0f);
  const Hit pillar = hitAt({4, 4, 4}, 3.5f);
  EXPECT_EQ(figuresOf(oracle_, {{past(within), kMiss}}).boundary, 1u);
  EXPECT_EQ(figuresOf(oracle_, {{past(4.99f), kMiss}}).boundary, 0u);
  EXPECT_EQ(figuresOf(oracle_, {{past(5), pillar}}).boundary, 1u);
  EXPECT_EQ(figuresOf(oracle_, {{past(5.01f), pillar}}).boundary, 0u);
  // An empty voxel is no hit, however near.
  EXPECT_EQ(figuresOf(oracle_, {{past(5), hitAt({5, 4, 4}, 3.5f)}}).boundary, 0u);
}

TEST_F(OracleFigures, NothingExplainsAHitOfANonFiniteRay) {
  for (float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
    for (int component = 0; component < 6; ++component) {
      Ray ray = kDown;
      (component < 3 ? ray.origin[component] : ray.direction[component - 3]) = bad;
      const ErrorFigures figures = figuresOf(oracle_, {{ray, hitAt({1, 1, 1}, 3)}});
      EXPECT_EQ(figures.ghost, 1u);
      EXPECT_EQ(figures.boundary, 0u);
    }
}

TEST_F(OracleFigures, RoundingExplainsWhatLiesBehindAVoxelBarelyMet) {
  // Down past the pillar at x = 5 to the floor: its top is 4 above.
  const auto down = [](float x) { return Ray{{x, 8, 4.5f}, {0, -1, 0}}; };
  const float within = std::nextafter(5.0f, 0.0f);
  EXPECT_EQ(figuresOf(oracle_, {{down(within), hitAt({5, 1, 4}, 6)}}).boundary, 1u);
  EXPECT_EQ(figuresOf(oracle_, {{down(4.5f), hitAt({4, 1, 4}, 6)}}).boundary, 0u);
  EXPECT_EQ(figuresOf(oracle_, {{down(5), hitAt({4, 5, 4}, 2)}}).boundary, 1u);
  EXPECT_EQ(figuresOf(oracle_, {{down(5.5f), hitAt({4, 5, 4}, 2)}}).boundary, 0u);
}

TEST_F(OracleFigures, RoundingExplainsAVoxelBarelyMissedOnTheWay) {
  // Exactly over the pillar's top edge at (5, 6), then well into the floor at (6.5, 2).
  const auto over = [](float x) { return Ray{{x, 9, 4.5f}, {0.75f, -2, 0}}; };
  const Hit pillar = hitAt({4, 5, 4}, 1.5f);
  const ErrorFigures figures = figuresOf(oracle_, {{over(3.875f), pillar}, {over(3.9f), pillar}});
  EXPECT_EQ(figures.wrong, 2u);
  EXPECT_EQ(figures.boundary, 1u);
}

} // namespace
} // namespace voxc::test
