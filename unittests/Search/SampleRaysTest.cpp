// Rays that are simulated: packets of those that were given, in the order in which a tracer takes them.
#include "voxc/Search/SampleRays.h"
#include "voxc/Plan/Plan.h"
#include "voxc/Search/RayCostModel.h"
#include "voxc/Source/Sources.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

namespace voxc {
namespace {

/// Rays that begin anywhere and go any way, each with its number in the origin.
std::vector<Ray> scatteredRays(std::size_t count) {
  std::mt19937 random(3);
  const auto any = [&](float least, float most) {
    return std::uniform_real_distribution<float>(least, most)(random);
  };
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < count; ++i)
    rays.push_back(makeRay({any(0, 64), any(0, 64), any(0, 64)}, {any(-1, 1), any(-1, 1), any(-1, 1)}));
  return rays;
}

/// Of neighbours in a packet, those that go another way than the one before.
double changesOf(const std::vector<Ray> &rays) {
  int changes = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
    for (int axis = 0; i % kSimulatedPacket != 0 && axis < 3; ++axis)
      changes += std::signbit(rays[i].direction[axis]) != std::signbit(rays[i - 1].direction[axis]);
  return changes / static_cast<double>(rays.size());
}

TEST(SampleRays, ScatteredRaysAreBinnedAsATracerBinsThem) {
  const std::vector<Ray> rays = scatteredRays(1 << 16);
  const RaySet binned = samplePackets("any", rays, 1007, 64, RayOrder::Auto);
  EXPECT_TRUE(binned.isBinned);
  EXPECT_EQ(binned.rays.size(), 1000u);
  EXPECT_LT(changesOf(binned.rays), 0.05);
  const auto order = binnedOrder(RaySpan(rays), 64, 1);
  for (std::size_t i = 0; i < kSimulatedPacket; ++i)
    EXPECT_EQ(std::memcmp(&binned.rays[i], &rays[order[i]], sizeof(Ray)), 0);
}

TEST(SampleRays, AsGivenIsAsGiven) {
  const std::vector<Ray> rays = scatteredRays(1 << 16);
  const RaySet given = samplePackets("any", rays, 1000, 64, RayOrder::Given);
  EXPECT_FALSE(given.isBinned);
  EXPECT_GT(changesOf(given.rays), 1);
  // From all over the rays, packet by packet.
  for (std::size_t i = 0; i < kSimulatedPacket; ++i)
    EXPECT_EQ(std::memcmp(&given.rays[given.rays.size() - kSimulatedPacket + i],
                          &rays[(1 << 16) / 125 * 124 + i], sizeof(Ray)),
              0);
}

TEST(SampleRays, FewRaysAreNotBinned) {
  EXPECT_FALSE(samplePackets("few", scatteredRays(1 << 10), 1000, 64, RayOrder::Auto).isBinned);
}

/// Turns of a ray in an octree of the scene, on average.
double turnsOf(const SceneDag &dag, const std::vector<Ray> &rays) {
  return modelRayCost(dag, rays, *makePlan(*parseFormat("S(6)"), kCpuPlan)).turns;
}

TEST(SampleRays, TypicalPacketsTellWhatAllCost) {
  const SceneDag dag = *SceneDag::build(**makeBuiltinSource("terrain", 64), {});
  const RaySet all = samplePackets("any", scatteredRays(1 << 16), 1 << 16, 64, RayOrder::Auto);
  const RaySet typical = typicalPackets(dag, all, 260);
  EXPECT_EQ(typical.rays.size(), 256u);
  EXPECT_TRUE(typical.isBinned);
  EXPECT_NEAR(turnsOf(dag, typical.rays) / turnsOf(dag, all.rays), 1, 0.02);
  // Those that go far stand last.
  const std::vector<Ray> first(typical.rays.begin(), typical.rays.begin() + 64);
  EXPECT_LT(turnsOf(dag, first), 0.8 * turnsOf(dag, all.rays));
  EXPECT_EQ(typicalPackets(dag, typical, 1000).rays.size(), 256u);
}

} // namespace
} // namespace voxc
