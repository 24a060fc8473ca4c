// Tracing within a budget where coarse blocks may answer rays.
#include "PagingTesting.h"
#include "TestLength.h"

#include "testing/RandomFormat.h"
#include "voxc/Oracle/VerifyRays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace voxc {
namespace {

using namespace test;
using ::testing::HasSubstr;

/// A block is never seen from so near.
constexpr float kLarge = 1e-30f;
/// A block may stand in wherever it is, but for the one that the eye is in.
constexpr float kSmall = 1e30f;

class CoarseTracing : public Paging {
protected:
  /// A file of the volume with its blocks.
  PagedVolume coarse(const Format &format, const HardScene &scene, int log2Side) {
    auto built = build(format, scene);
    EXPECT_TRUE(built) << built.error().message;
    volume_ = std::make_shared<const Volume>(std::move(*built));
    return paged(*withCoarseBlocks(volume_, *makeCoarseBlocks(*volume_, log2Side)));
  }

  /// Tracers on all back ends that there are.
  static std::vector<std::unique_ptr<PagedTracer>> tracers(const PagedVolume &volume, const Format &format,
                                                           std::optional<Device> &device) {
    std::vector<std::unique_ptr<PagedTracer>> all;
    auto cpu = createPagedCpuTracer(cpuKernel(format), volume, {leastPagingBytes(volume), 2, true});
    EXPECT_TRUE(cpu) << cpu.error().message;
    all.push_back(std::move(*cpu));
    if (auto opened = Device::open("llvmpipe")) {
      device.emplace(std::move(*opened));
      auto vulkan = onVulkan(*device, volume, format, leastPagingBytes(volume), true);
      EXPECT_TRUE(vulkan) << vulkan.error().message;
      all.push_back(std::move(*vulkan));
    }
    return all;
  }

  std::shared_ptr<const Volume> volume_;
};

TraceOptions seenFrom(const Ray &ray, float spread) {
  TraceOptions options;
  for (int axis = 0; axis < 3; ++axis)
    options.coarse.from[axis] = ray.origin[axis];
  options.coarse.spread = spread;
  return options;
}

/// What rays miss is certain, also of those that graze voxels, and nothing else is told.
TEST_F(CoarseTracing, IsExactWhereBlocksLookLarge) {
  std::mt19937 random(17);
  for (int i = 0; i < rounds(4); ++i) {
    const Format format = randomFormat(random, pick(random, 3, 6));
    const HardScene scene = i % 2 == 0 ? noise(format.extent(), i) : sceneOf(format, random());
    const PagedVolume volume = coarse(format, scene, kLeastLog2CoarseSide + i % 3);
    if (volume_->layout().payload == Payload::Material)
      continue;
    const auto rays = verifyRays(scene.extent, 1000, random());
    const auto expected = residentHits(*volume_, format, rays);
    std::optional<Device> device;
    for (const auto &tracer : tracers(volume, format, device))
      for (const float spread : {kLarge, 0.0f}) {
        std::vector<Hit> hits(rays.size());
        const auto report = tracer->trace(rays, hits, seenFrom(rays[0], spread));
        ASSERT_TRUE(report) << report.error().message;
        EXPECT_EQ(report->coarse, 0u);
        EXPECT_EQ(differences(expected, hits), "") << printIr(format);
      }
  }
}

/// From far outside all blocks look small.
TEST_F(CoarseTracing, AnswersByTheBoxesThatRaysMeetFirst) {
  const Format format = *parseFormat("format { level 1: svdag(6) }");
  const HardScene scene = noise(format.extent(), 9);
  for (const int log2Side : {2, 4}) {
    const PagedVolume volume = coarse(format, scene, log2Side);
    std::map<std::uint64_t, CoarseBlock> blocks;
    const auto made = makeCoarseBlocks(*volume_, log2Side);
    for (const CoarseBlock &block : made->blocks)
      blocks[block.code] = block;
    std::vector<Ray> rays;
    for (int i = 0; i < 4000; ++i)
      rays.push_back({{-40, 20, 31}, {1, -0.5f + float(i % 63) / 63, -0.5f + float(i) / 4000}});
    const auto exact = residentHits(*volume_, format, rays);
    std::optional<Device> device;
    std::vector<Hit> first;
    for (const auto &tracer : tracers(volume, format, device)) {
      std::vector<Hit> hits(rays.size());
      const auto report = tracer->trace(rays, hits, seenFrom(rays[0], kSmall));
      ASSERT_TRUE(report) << report.error().message;
      EXPECT_GT(report->coarse, rays.size() / 4);
      if (first.empty())
        first = hits;
      EXPECT_EQ(differences(first, hits), "");
      std::uint64_t wrong = 0;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i].isHit() || std::memcmp(&hits[i], &exact[i], sizeof(Hit)) == 0) {
          wrong += hits[i].isHit() ? 0 : exact[i].isHit(); // No voxel is without a box.
          continue;
        }
        const Int3 voxel = {hits[i].voxel[0], hits[i].voxel[1], hits[i].voxel[2]};
        const auto block = blocks.find(mortonCode(voxel >> log2Side));
        wrong += block == blocks.end() || block->second.rgba != hits[i].rgba ||
                 (exact[i].isHit() && hits[i].t > exact[i].t + 1e-3f);
      }
      EXPECT_EQ(wrong, 0u);
      EXPECT_LT(tracer->paging().reads, tracer->paging().pages / 4);
    }
  }
}

/// What is near is exact, and what is far may be a block.
TEST_F(CoarseTracing, AsksForThePagesOfWhatLooksLarge) {
  const Format format = *parseFormat("format { level 1: svdag(7) }");
  const PagedVolume volume = coarse(format, noise(format.extent(), 4), 2);
  std::vector<Ray> rays;
  for (int i = 0; i < 3000; ++i)
    rays.push_back({{64, 64, 64}, {std::cos(float(i)), std::sin(float(i)), -1 + 2 * float(i) / 3000}});
  const auto exact = residentHits(*volume_, format, rays);
  std::optional<Device> device;
  for (const auto &tracer : tracers(volume, format, device)) {
    std::vector<Hit> hits(rays.size());
    const float near = 12;
    const auto report = tracer->trace(rays, hits, seenFrom(rays[0], 4 / near));
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_GT(report->coarse, 0u);
    std::uint64_t nearHits = 0, wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const float *const d = rays[i].direction;
      const float distance = exact[i].t * std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      if (!exact[i].isHit() || distance > near - 7) // No box of such a voxel looks small.
        continue;
      ++nearHits;
      wrong += std::memcmp(&hits[i], &exact[i], sizeof(Hit)) != 0;
    }
    EXPECT_GT(nearHits, 100u);
    EXPECT_EQ(wrong, 0u);
  }
}

TEST_F(CoarseTracing, NeedsBlocksAndRaysWithoutBounds) {
  Format format = *parseFormat("format { level 1: svdag(4) }");
  const auto built = build(format, noise(format.extent(), 4));
  ASSERT_TRUE(built);
  const PagedVolume none = paged(*built);
  const auto missing = createPagedCpuTracer(cpuKernel(format), none, {1 << 20, 1, true});
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("has no coarse blocks"));
  const PagedVolume some = coarse(format, noise(format.extent(), 4), 2);
  format.setAttribute(kBoundsAttribute, "yes");
  const auto bounded = createPagedCpuTracer(cpuKernel(format), some, {1 << 20, 1, true});
  ASSERT_FALSE(bounded);
  EXPECT_THAT(bounded.error().message, HasSubstr("without bounds"));
}

} // namespace
} // namespace voxc
