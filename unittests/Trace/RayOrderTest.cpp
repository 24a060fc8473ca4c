// The order in which rays are taken: bins, when they are chosen, and that hits come back where they belong.
#include "voxc/Trace/RayOrder.h"
#include "voxc/Trace/CpuKernel.h"
#include "voxc/Trace/SampleIndex.h"

#include "Trace/Rays/OrderChoice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <set>

namespace voxc {
namespace {

constexpr int kEdge = 64;

std::vector<Ray> scatteredRays(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(0, kEdge);
  std::normal_distribution<float> direction;
  std::vector<Ray> rays(count);
  for (Ray &ray : rays)
    ray = {{place(random), place(random), place(random)},
           {direction(random), direction(random), direction(random)}};
  return rays;
}

/// A camera's: from one place, in a narrow cone.
std::vector<Ray> coherentRays(std::size_t count) {
  std::vector<Ray> rays(count);
  for (std::size_t i = 0; i < count; ++i)
    rays[i] = {{-3, 30, 30}, {1, 0.1F + 1e-6F * static_cast<float>(i), 0.2F}};
  return rays;
}

unsigned octant(const Ray &ray) {
  return unsigned(std::signbit(ray.direction[0])) | unsigned(std::signbit(ray.direction[1])) << 1 |
         unsigned(std::signbit(ray.direction[2])) << 2;
}

TEST(RayOrder, NamesAreThoseOfTheCommandLine) {
  EXPECT_EQ(rayOrderFrom("auto"), RayOrder::Auto);
  EXPECT_EQ(rayOrderFrom("given"), RayOrder::Given);
  EXPECT_EQ(rayOrderFrom("binned"), RayOrder::Binned);
}

TEST(RayOrder, EveryRayStandsInItOnce) {
  const auto rays = scatteredRays(10007);
  auto order = binnedOrder(rays, kEdge, 3);
  std::ranges::sort(order);
  for (std::size_t i = 0; i < order.size(); ++i)
    ASSERT_EQ(order[i], i);
}

TEST(RayOrder, OctantsAreTogether) {
  const auto rays = scatteredRays(5000);
  const auto order = binnedOrder(rays, kEdge, 2);
  EXPECT_TRUE(std::ranges::is_sorted(order, {}, [&](std::uint32_t ray) { return octant(rays[ray]); }));
}

TEST(RayOrder, RaysOfABinStayAsGiven) {
  const auto order = binnedOrder(coherentRays(1000), kEdge, 4);
  EXPECT_TRUE(std::ranges::is_sorted(order));
}

TEST(RayOrder, ItDoesNotDependOnThreads) {
  const auto rays = scatteredRays(20011);
  const auto alone = binnedOrder(rays, kEdge, 1);
  for (const unsigned threads : {2u, 5u, 64u})
    EXPECT_EQ(binnedOrder(rays, kEdge, threads), alone) << threads;
  EXPECT_EQ(binnedOrder(std::span(rays).first(3), kEdge, 8).size(), 3u) << "fewer rays than threads";
}

TEST(RayOrder, WhatIsNoNumberHasABinToo) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::vector<Ray> rays = scatteredRays(100);
  rays[3] = {{kNan, kNan, kNan}, {kNan, kNan, kNan}};
  rays[4] = {{kInfinity, -kInfinity, 3e38F}, {kInfinity, -kInfinity, 0}};
  rays[5] = {{0, 0, 0}, {0, 0, 0}};
  rays[6] = {{-3e38F, 3e38F, 0}, {3e38F, 3e38F, 3e38F}};
  auto order = binnedOrder(rays, kEdge, 2);
  std::ranges::sort(order);
  for (std::size_t i = 0; i < order.size(); ++i)
    ASSERT_EQ(order[i], i);
}

TEST(RayOrder, ManyScatteredRaysAreTold) {
  EXPECT_TRUE(areScattered(scatteredRays(40000), kEdge));
  EXPECT_FALSE(areScattered(scatteredRays(20000), kEdge)) << "too few for bins to pay";
  EXPECT_FALSE(areScattered(coherentRays(40000), kEdge));
  EXPECT_FALSE(areScattered({}, kEdge));
}

/// Not a kernel of any format: every ray hits the voxel that its origin names, at the length of its
/// direction.
void echoOrdered(const std::uint32_t *, const float *rays, std::uint32_t *hits, unsigned long long count, int,
                 float) {
  for (unsigned long long i = 0; i < count; ++i, rays += 6, hits += 6) {
    const Hit hit{{int(rays[0]), int(rays[1]), int(rays[2])}, 1, std::hypot(rays[3], rays[4], rays[5]), 0};
    std::memcpy(hits, &hit, sizeof hit);
  }
}

class OrderedTracerTest : public testing::Test {
protected:
  TraceReport trace(std::span<const Ray> rays, RayOrder order, std::vector<Hit> &hits) {
    hits.assign(rays.size(), {});
    auto tracer = createCpuTracer({echoOrdered, volume_.storageDigest(), nullptr}, volume_, 2);
    EXPECT_TRUE(tracer) << tracer.error().message;
    double last = 0;
    TraceOptions options{.repeat = 2, .order = order};
    options.progress.report = [&](std::string_view, double fraction, std::uint64_t) {
      EXPECT_LE(last, fraction);
      last = fraction;
    };
    const auto report = (*tracer)->trace(rays, hits, options);
    EXPECT_TRUE(report) << report.error().message;
    EXPECT_EQ(report->repeats.size(), 2u);
    EXPECT_EQ(last, 1);
    return *report;
  }

  Volume volume_{{.format = *parseFormat("R(6, 6, 6)"), .extent = {kEdge, kEdge, kEdge}},
                 std::vector<std::uint32_t>{0}};
};

TEST_F(OrderedTracerTest, HitsAreTheSameInAnyOrder) {
  // More than are ordered at once.
  const auto rays = scatteredRays((std::size_t{1} << 22) + 12345);
  std::vector<Hit> given;
  std::vector<Hit> binned;
  EXPECT_FALSE(trace(rays, RayOrder::Given, given).binned);
  EXPECT_TRUE(trace(rays, RayOrder::Binned, binned).binned);
  EXPECT_EQ(std::memcmp(given.data(), binned.data(), given.size() * sizeof(Hit)), 0);
}

TEST_F(OrderedTracerTest, AutoMeasuresOnceWhatIsScattered) {
  auto tracer = createCpuTracer({echoOrdered, volume_.storageDigest(), nullptr}, volume_, 2);
  const auto traced = [&](const std::vector<Ray> &rays) {
    std::vector<Hit> hits(rays.size());
    const auto report = (*tracer)->trace(rays, hits, {.order = RayOrder::Auto});
    EXPECT_TRUE(report) << report.error().message;
    return *report;
  };
  const TraceReport first = traced(scatteredRays(40000)), second = traced(scatteredRays(41000)),
                    coherent = traced(coherentRays(40000));
  EXPECT_GT(first.choosing, 0);
  EXPECT_EQ(second.choosing, 0);
  EXPECT_EQ(second.binned, first.binned);
  EXPECT_EQ(coherent.choosing, 0);
  EXPECT_FALSE(coherent.binned);
}

TEST_F(OrderedTracerTest, NoRaysNeedNoOrder) {
  auto tracer = createCpuTracer({echoOrdered, volume_.storageDigest(), nullptr}, volume_, 2);
  const auto report = (*tracer)->trace({}, {}, {.repeat = 2, .order = RayOrder::Binned});
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->repeats.size(), 2u);
}

TEST(OrderChoice, IsKeptForCallsOfAboutAsMany) {
  OrderChoice choice;
  EXPECT_FALSE(choice.isKnown(100000));
  choice.learn(true, 100000);
  EXPECT_TRUE(choice.isKnown(100000));
  EXPECT_FALSE(choice.isKnown(3000000));
  int calls = 0;
  for (; choice.isKnown(100000); ++calls)
    EXPECT_TRUE(choice.use());
  EXPECT_EQ(calls, 64);
}

TEST(OrderChoice, ComparesOnlyWhereOrderingIsNotTooDear) {
  EXPECT_FALSE(OrderChoice::mayPay(1, 0.8)) << "rays that hit at once";
  EXPECT_TRUE(OrderChoice::mayPay(1, 0.2));
  EXPECT_TRUE(OrderChoice::pays(1, 0.9));
  EXPECT_FALSE(OrderChoice::pays(1, 1.3));
}

TEST(Sample, HasOneRayOfEachStretchAndSeesEveryColumn) {
  // A step of 128 would see 4 columns.
  constexpr std::size_t kWidth = 512, kAll = kWidth * 512, kCount = 2048;
  std::set<std::size_t> columns;
  for (std::size_t i = 0; i < kCount; ++i) {
    const std::size_t at = sampleIndex(i, kCount, kAll);
    EXPECT_EQ(at / (kAll / kCount), i);
    columns.insert(at % kWidth);
  }
  EXPECT_GT(columns.size(), kWidth * 9 / 10);
}

TEST(Sample, OfAllIsAll) {
  for (std::size_t i = 0; i < 1000; ++i)
    EXPECT_EQ(sampleIndex(i, 1000, 1000), i);
  EXPECT_LT(sampleIndex(2, 3, 7), 7u);
}

} // namespace
} // namespace voxc
