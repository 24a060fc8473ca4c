// Kernels that are compiled in parts: the hits are the same whichever parts there are.
#include "BuiltScene.h"
#include "testing/HardScenes.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Oracle/VerifyRays.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include <unistd.h>

namespace voxc {
namespace {

/// More than a kernel traces one by one.
constexpr std::size_t kManyRays = 270'000;
constexpr std::size_t kFewRays = 6000;

constexpr const char *kFormats[] = {
    "format { level 1: raw(2, 2, 2) level 2: svdag(3) }",
    "format face=yes { level 1: distance(2, 2, 2, 7) level 2: masked(2, 2, 2) }",
    "format bounds=yes { level 1: svdag(5) }",
    "format precision=fast { level 1: svo(3) level 2: raw(2, 2, 2) }",
};

/// Rays as a kernel takes them, with bounds that cut some short where it wants them.
std::vector<float> numbersOf(std::span<const Ray> rays, bool bounded) {
  std::vector<float> numbers;
  for (const Ray &ray : rays) {
    numbers.insert(numbers.end(), ray.origin, ray.origin + 3);
    if (bounded)
      numbers.push_back(numbers.size() % 5 == 0 ? 3.0f : 0.0f);
    numbers.insert(numbers.end(), ray.direction, ray.direction + 3);
    if (bounded)
      numbers.push_back(numbers.size() % 3 == 0 ? 9.5f : 1e6f);
  }
  return numbers;
}

std::vector<Hit> traced(const CpuKernel &kernel, const Volume &volume, std::span<const float> numbers,
                        int countLookups = 0) {
  std::vector<Hit> hits(numbers.size() / (kernel.bounded ? 8 : 6));
  kernel.function(volume.words().data(), numbers.data(), reinterpret_cast<std::uint32_t *>(hits.data()),
                  hits.size(), countLookups, 0);
  return hits;
}

/// From the middle of a cell, and close to no edge: nothing that exact arithmetic has to look at.
constexpr Ray kEasyRay = {{-1.0f, 3.25f, 5.25f}, {1.0f, 0.125f, 0.0625f}};

/// Has a kernel trace so many rays that it takes packets from then on.
void traceMany(const CpuKernel &kernel, const Volume &volume) {
  traced(kernel, volume, numbersOf(std::vector<Ray>(kManyRays, kEasyRay), kernel.bounded));
}

TEST(CpuStart, GivesTheHitsOfPacketsWithoutThem) {
  for (const char *text : kFormats) {
    const Format format = *parseFormat(text);
    const test::HardScene scene = test::hardScenes(format.extent())[7];
    const Volume volume = test::builtScene(format, scene);
    const auto soon = compileCpuKernel(format, {.start = CpuStart::Soon});
    const auto fast = compileCpuKernel(format, {.start = CpuStart::Fast});
    ASSERT_TRUE(soon) << soon.error().message;
    ASSERT_TRUE(fast) << fast.error().message;
    const auto numbers = numbersOf(verifyRays(scene.extent, kFewRays, 11), fast->bounded);
    for (const bool hasPackets : {false, true}) {
      if (hasPackets)
        traceMany(*soon, volume);
      for (const int countLookups : {0, 1}) {
        const auto expected = traced(*fast, volume, numbers, countLookups);
        const auto hits = traced(*soon, volume, numbers, countLookups);
        EXPECT_EQ(std::memcmp(hits.data(), expected.data(), hits.size() * sizeof(Hit)), 0)
            << text << ", " << hasPackets << ", " << countLookups;
      }
    }
  }
}

/// How many objects a folder of compiled code has.
std::uint64_t objectsIn(const CompileCache &cache) { return cache.usage().entries; }

TEST(CpuStart, CompilesPartsWhenTheyAreAskedFor) {
  const std::string folder =
      (std::filesystem::temp_directory_path() / ("voxc-start-" + std::to_string(::getpid()))).string();
  const auto cache = CompileCache::open(folder);
  ASSERT_TRUE(cache) << cache.error().message;
  const Format format = *parseFormat("G(4)");
  const test::HardScene scene = test::hardScenes(format.extent())[7];
  const Volume volume = test::builtScene(format, scene);
  const auto soon = compileCpuKernel(format, {.cache = &*cache, .start = CpuStart::Soon});
  ASSERT_TRUE(soon) << soon.error().message;
  ASSERT_TRUE(intersect(volume, *soon, kEasyRay));
  EXPECT_EQ(objectsIn(*cache), 1u);
  const Ray still{{1.5f, 1.5f, 1.5f}, {0.0f, 0.0f, 0.0f}};
  ASSERT_TRUE(intersect(volume, *soon, still));
  EXPECT_EQ(objectsIn(*cache), 2u) << "a ray that goes nowhere is one for exact arithmetic";
  traceMany(*soon, volume);
  ASSERT_TRUE(traced(*soon, volume, numbersOf(std::vector<Ray>(2, kEasyRay), false)).size() == 2);
  EXPECT_EQ(objectsIn(*cache), 3u) << "many rays are traced in packets";
  const auto whole = compileCpuKernel(format, {.cache = &*cache, .start = CpuStart::Whole});
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(objectsIn(*cache), 4u) << "what is timed compiles nothing on the way";
  ASSERT_TRUE(intersect(volume, *whole, still));
  traceMany(*whole, volume);
  EXPECT_EQ(objectsIn(*cache), 4u);
  std::filesystem::remove_all(folder);
}

} // namespace
} // namespace voxc
