// The tracer: many rays, none, and what it refuses.
#include "voxc/Trace/Tracer.h"
#include "voxc/Kernel/Compile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>

namespace voxc {
namespace {

using testing::HasSubstr;

constexpr std::uint32_t kRed = 0xff0000ff;

Format format(const char *text) {
  auto parsed = parseFormat(text);
  EXPECT_TRUE(parsed);
  return *parsed;
}

/// 4x4x4 voxels of which (2, 1, 3) alone is there.
Volume oneVoxel() {
  std::vector<std::uint32_t> words(1 + 64);
  words[0] = 1;
  words[1 + 2 + 4 * (1 + 4 * 3)] = kRed;
  return Volume({.format = format("R(2, 2, 2)"), .extent = {4, 4, 4}, .voxels = 1}, std::move(words));
}

/// Looks along z at column (x, y).
Ray rayAt(int x, int y) { return {{float(x) + 0.5f, float(y) + 0.5f, -2}, {0, 0, 1}}; }

class TracerTest : public testing::Test {
protected:
  void SetUp() override {
    auto device = Device::open();
    if (!device)
      GTEST_SKIP() << device.error().message;
    device_.emplace(std::move(*device));
    makeTracer(Addressing::Buffer);
  }

  void makeTracer(Addressing addressing) {
    auto kernel = compileKernel(volume_.format(), {.addressing = addressing});
    ASSERT_TRUE(kernel) << kernel.error().message;
    auto made = createTracer(*device_, *kernel, volume_);
    ASSERT_TRUE(made) << made.error().message;
    tracer_ = std::move(*made);
  }

  void expectHitAndMiss() {
    std::vector<Ray> rays = {rayAt(2, 1), rayAt(2, 2)};
    std::vector<Hit> hits(2);
    auto report = tracer_->trace(rays, hits);
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_EQ(hits[0].voxel[2], 3);
    EXPECT_EQ(hits[0].rgba, kRed);
    EXPECT_EQ(hits[0].t, 5);
    EXPECT_EQ(hits[0].steps, 0u);
    EXPECT_FALSE(hits[1].isHit());
  }

  Volume volume_ = oneVoxel();
  std::optional<Device> device_;
  std::unique_ptr<Tracer> tracer_; ///< Destroyed before the device.
};

TEST_F(TracerTest, ReadsWordsFromABuffer) { expectHitAndMiss(); }

TEST_F(TracerTest, ReadsWordsFromSegments) {
  if (!device_->info().deviceAddresses)
    GTEST_SKIP() << device_->info().name << " has no device addresses";
  ASSERT_NO_FATAL_FAILURE(makeTracer(Addressing::Segments));
  expectHitAndMiss();
}

TEST_F(TracerTest, NoRaysAreTracedAtOnce) {
  auto report = tracer_->trace({}, {}, {.repeat = 3});
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->repeats.size(), 3u);
}

TEST_F(TracerTest, LookupsAreCountedOnRequest) {
  std::vector<Ray> rays = {rayAt(2, 1)};
  std::vector<Hit> hits(1);
  ASSERT_TRUE(tracer_->trace(rays, hits, {.countSteps = true}));
  EXPECT_GT(hits[0].steps, 0u);
  ASSERT_TRUE(tracer_->trace(rays, hits));
  EXPECT_EQ(hits[0].steps, 0u);
}

TEST_F(TracerTest, RaysKeepTheirOrderOverTilesAndBatches) {
  // More than four tiles, and so more than one batch; 7 is prime to every size in between.
  std::vector<Ray> rays((std::size_t{4} << 20) + 12345);
  for (std::size_t i = 0; i < rays.size(); ++i)
    rays[i] = i % 7 == 3 ? rayAt(2, 1) : rayAt(0, 0);
  std::vector<Hit> hits(rays.size());
  auto report = tracer_->trace(rays, hits);
  ASSERT_TRUE(report) << report.error().message;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < hits.size(); ++i)
    wrong += hits[i].isHit() != (i % 7 == 3);
  EXPECT_EQ(wrong, 0u);
}

TEST_F(TracerTest, LaterTracesMayHaveMoreRays) {
  for (std::size_t count : {1u, 1000u, 10u}) {
    std::vector<Ray> rays(count, rayAt(2, 1));
    std::vector<Hit> hits(count);
    ASSERT_TRUE(tracer_->trace(rays, hits));
    EXPECT_TRUE(std::ranges::all_of(hits, &Hit::isHit));
  }
}

TEST_F(TracerTest, StopsWhenAsked) {
  std::atomic<bool> stop = true;
  std::vector<Ray> rays(100, rayAt(2, 1));
  std::vector<Hit> hits(rays.size());
  auto report = tracer_->trace(rays, hits, {.progress = {.stop = &stop}});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, ErrorKind::Interrupted);
}

TEST_F(TracerTest, ProgressEndsAtOne) {
  std::vector<Ray> rays(100, rayAt(2, 1));
  std::vector<Hit> hits(rays.size());
  double last = 0;
  TraceOptions options{.repeat = 2};
  options.progress.report = [&](std::string_view, double fraction, std::uint64_t) { last = fraction; };
  ASSERT_TRUE(tracer_->trace(rays, hits, options));
  EXPECT_EQ(last, 1);
}

TEST_F(TracerTest, RaysAndHitsMustMatch) {
  std::vector<Ray> rays(2, rayAt(0, 0));
  std::vector<Hit> hits(1);
  EXPECT_FALSE(tracer_->trace(rays, hits));
}

TEST_F(TracerTest, KernelsOfOtherStorageAreRefused) {
  auto kernel = compileKernel(format("S(2)"));
  ASSERT_TRUE(kernel) << kernel.error().message;
  auto made = createTracer(*device_, *kernel, volume_);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().kind, ErrorKind::Input);
  EXPECT_THAT(made.error().message, HasSubstr("R(2, 2, 2)"));
}

} // namespace
} // namespace voxc
