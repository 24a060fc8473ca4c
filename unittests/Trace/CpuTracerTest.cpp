// The tracer on this processor, around a kernel that needs no compiler: many rays, none, and what it refuses.
#include "voxc/Trace/CpuKernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <ctime>
#include <numeric>

namespace voxc {
namespace {

Volume emptyVolume() {
  const Format format = *parseFormat("R(2, 2, 2)");
  return Volume({.format = format, .extent = {4, 4, 4}}, std::vector<std::uint32_t>{0});
}

/// Not a kernel of any format: every ray hits the voxel that its origin names, after one lookup.
void echo(const std::uint32_t *, const float *rays, std::uint32_t *hits, unsigned long long count,
          int countLookups, float) {
  for (unsigned long long i = 0; i < count; ++i) {
    Hit hit{{0, 0, 0}, 1, 0, countLookups ? 1u : 0u};
    for (int axis = 0; axis < 3; ++axis)
      hit.voxel[axis] = static_cast<std::int32_t>(rays[6 * i + static_cast<unsigned>(axis)]);
    std::memcpy(hits + 6 * i, &hit, sizeof hit);
  }
}

class CpuTracerTest : public testing::TestWithParam<unsigned> {
protected:
  std::unique_ptr<Tracer> tracer() {
    auto made = createCpuTracer({echo, volume_.storageDigest(), nullptr}, volume_, GetParam());
    EXPECT_TRUE(made) << made.error().message;
    return std::move(*made);
  }

  static std::vector<Ray> numbered(std::size_t count) {
    std::vector<Ray> rays(count);
    for (std::size_t i = 0; i < count; ++i)
      rays[i].origin[0] = static_cast<float>(i);
    return rays;
  }

  Volume volume_ = emptyVolume();
};

TEST_P(CpuTracerTest, RaysKeepTheirOrderOverChunks) {
  const auto rays = numbered(100003);
  std::vector<Hit> hits(rays.size());
  const auto report = tracer()->trace(rays, hits, {.countSteps = true});
  ASSERT_TRUE(report) << report.error().message;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    ASSERT_EQ(hits[i].voxel[0], static_cast<int>(i));
    ASSERT_EQ(hits[i].steps, 1u);
  }
}

/// Windows counts the time of a process in steps of some milliseconds, which few rays do not take.
bool hasFineCpuTime() {
  timespec step{};
  ::clock_getres(CLOCK_PROCESS_CPUTIME_ID, &step);
  return step.tv_sec == 0 && step.tv_nsec < 1000000;
}

TEST_P(CpuTracerTest, EveryRepeatIsTimed) {
  const auto rays = numbered(10000);
  std::vector<Hit> hits(rays.size());
  const auto report = tracer()->trace(rays, hits, {.repeat = 3});
  ASSERT_TRUE(report) << report.error().message;
  ASSERT_EQ(report->repeats.size(), 3u);
  for (const TraceTime &time : report->repeats) {
    EXPECT_GT(time.wall, 0);
    EXPECT_GT(time.cpu, hasFineCpuTime() ? 0 : -1);
    EXPECT_EQ(time.device, 0);
  }
}

TEST_P(CpuTracerTest, NoRaysAreTracedAtOnce) {
  const auto report = tracer()->trace({}, {}, {.repeat = 2});
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->repeats.size(), 2u);
}

TEST_P(CpuTracerTest, StopsWhenAsked) {
  std::atomic<bool> stop = true;
  const auto rays = numbered(100);
  std::vector<Hit> hits(rays.size());
  const auto report = tracer()->trace(rays, hits, {.progress = {.stop = &stop}});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, ErrorKind::Interrupted);
}

TEST_P(CpuTracerTest, ProgressRisesToOne) {
  const auto rays = numbered(50000);
  std::vector<Hit> hits(rays.size());
  std::vector<double> fractions;
  TraceOptions options{.repeat = 2};
  options.progress.report = [&](std::string_view, double fraction, std::uint64_t) {
    fractions.push_back(fraction);
  };
  ASSERT_TRUE(tracer()->trace(rays, hits, options));
  ASSERT_FALSE(fractions.empty());
  EXPECT_TRUE(std::ranges::is_sorted(fractions));
  EXPECT_EQ(fractions.back(), 1);
}

TEST_P(CpuTracerTest, RaysAndHitsMustMatch) {
  std::vector<Hit> hits(1);
  EXPECT_FALSE(tracer()->trace(numbered(2), hits));
}

INSTANTIATE_TEST_SUITE_P(Threads, CpuTracerTest, testing::Values(0u, 1u, 2u, 7u));

TEST(CpuTracer, RefusesKernelsOfOtherStorage) {
  const Volume volume = emptyVolume();
  const auto made = createCpuTracer({echo, volume.storageDigest() + 1, nullptr}, volume);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().kind, ErrorKind::Input);
  EXPECT_NE(made.error().message.find("R(2, 2, 2)"), std::string::npos);
}

} // namespace
} // namespace voxc
