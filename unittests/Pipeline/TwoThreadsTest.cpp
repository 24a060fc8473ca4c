// The library does for two threads at once what it does for one: nothing of it is shared that may change.
#include "TestLength.h"

#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "testing/RandomRays.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Kernel/OpenTracer.h"

#include <gtest/gtest.h>

#include <cstring>
#include <thread>
#include <vector>

namespace voxc {
namespace {

/// Compiles, builds, edits and traces some random formats: all the hits.
std::vector<Hit> work(unsigned seed, const std::string &device) {
  std::mt19937 random(seed);
  std::vector<Hit> all;
  for (int i = 0; i < test::rounds(2); ++i) {
    const Format format = test::randomFormat(random, 4);
    const auto constructor = Constructor::compile(format);
    const auto scenes = test::hardScenes(format.extent());
    const auto scene = scenes[random() % scenes.size()].source();
    const auto rays = test::raysInto(format.extent(), 500, random);
    auto built = constructor->build(*scene);
    EXPECT_TRUE(built) << built.error().message;
    const auto volume = std::make_shared<const Volume>(std::move(built->volume));
    const Int3 extent = format.extent();
    const Int3 size{std::min(extent.x, 2), std::min(extent.y, 3), std::min(extent.z, 4)};
    const auto emptied = constructor->edit(volume, std::vector{VoxelEdit{{0, 0, 0}, size, 0}});
    EXPECT_TRUE(emptied) << emptied.error().message;
    for (const Volume *traced : {&*volume, &emptied->volume}) {
      const auto tracer = openTracer(*traced, {.device = device, .threads = 2});
      EXPECT_TRUE(tracer) << tracer.error().message;
      std::vector<Hit> hits(rays.size());
      EXPECT_TRUE((*tracer)->trace(rays, hits));
      all.insert(all.end(), hits.begin(), hits.end());
    }
  }
  return all;
}

void expectTheSameFromTwoThreads(const std::string &device) {
  std::vector<Hit> hits[2];
  {
    std::jthread first([&] { hits[0] = work(1, device); }), second([&] { hits[1] = work(2, device); });
  }
  for (unsigned i = 0; i < 2; ++i) {
    const auto alone = work(i + 1, device);
    ASSERT_EQ(hits[i].size(), alone.size());
    EXPECT_EQ(std::memcmp(hits[i].data(), alone.data(), alone.size() * sizeof(Hit)), 0);
  }
}

TEST(TwoThreads, CompileBuildEditAndTraceAtOnce) { expectTheSameFromTwoThreads("cpu"); }

TEST(TwoThreads, TraceOnADeviceAtOnce) {
  if (const auto device = Device::open(); !device)
    GTEST_SKIP() << device.error().message;
  expectTheSameFromTwoThreads({});
}

} // namespace
} // namespace voxc
