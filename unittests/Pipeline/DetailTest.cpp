// Kernels that stop at what looks small: every traversal and addressing, and what they stop at.
#include "TestLength.h"

#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Oracle/VerifyRays.h"
#include "voxc/Trace/Tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace voxc {
namespace {

class DetailKernels : public ::testing::Test {
protected:
  void SetUp() override {
    auto device = Device::open("llvmpipe");
    if (!device)
      GTEST_SKIP() << "there is no llvmpipe device";
    device_ = std::make_unique<Device>(std::move(*device));
  }

  std::vector<Hit> hitsOf(const Volume &volume, Format format, const char *detail, float spread,
                          std::span<const Ray> rays, Addressing addressing = Addressing::Buffer) {
    format.setAttribute(kDetailAttribute, detail);
    const auto kernel = compileKernel(format, {addressing});
    EXPECT_TRUE(kernel) << kernel.error().message;
    const auto tracer = createTracer(*device_, *kernel, volume);
    EXPECT_TRUE(tracer) << tracer.error().message;
    std::vector<Hit> hits(rays.size());
    const auto report = (*tracer)->trace(rays, hits, {.spread = spread});
    EXPECT_TRUE(report) << report.error().message;
    return hits;
  }

  std::unique_ptr<Device> device_;
};

bool areSame(std::span<const Hit> a, std::span<const Hit> b) {
  return std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

/// Rays from outside, where even a voxel is far enough to be small for a great spread.
std::vector<Ray> raysFromOutside(Int3 extent, std::size_t count) {
  std::vector<Ray> outside;
  const float size[3] = {float(extent.x), float(extent.y), float(extent.z)};
  for (const Ray &ray : verifyRays(extent, count, 5)) {
    bool isOutside = false;
    for (int axis = 0; axis < 3; ++axis)
      isOutside |= ray.origin[axis] < -1 || ray.origin[axis] > size[axis] + 1;
    if (isOutside)
      outside.push_back(ray);
  }
  return outside;
}

TEST_F(DetailKernels, StopAtVoxelsWithoutSpread) {
  std::mt19937 random(21);
  for (int i = 0; i < test::rounds(4); ++i) {
    const Format format = test::randomFormat(random, test::pick(random, 4, 6));
    const auto scenes = test::hardScenes(format.extent());
    const auto built = Constructor::compile(format)->build(*scenes[random() % scenes.size()].source());
    const auto rays = verifyRays(format.extent(), 2000, random());
    EXPECT_TRUE(areSame(hitsOf(built->volume, format, "full", 0, rays),
                        hitsOf(built->volume, format, "cone", 0, rays)))
        << printIr(format);
  }
}

TEST_F(DetailKernels, StopAtTheFirstChildOfTheRootThatIsNotEmptyWhenAllIsSmall) {
  for (const char *text : {"S(5)", "G(5)", "R(1^3) G(4)", "D(1^3, 2) S(4)", "R(1^3) R(3^3) G(1)",
                           "D(1^3, 1) D(4^3, 6)", "S(1) R(4^3)", "G(1) S(0) D(4^3, 3)", "R(1^3) G(0) S(4)"}) {
    const Format format = *parseFormat(text);
    const auto voxel = [](Int3 c) {
      return (c.x * 7 + c.y * 13 + c.z * 29) % 40 == 0 && (c.y >= 16 || c.x < 16) ? 0xff00ffffu : 0u;
    };
    const auto built = Constructor::compile(format)->build(*makeFunctionSource({32, 32, 32}, voxel));
    // The root's children as voxels of a volume of their own, and the rays in its measure.
    const auto coarse =
        Constructor::compile(*parseFormat("R(1^3)"))->build(*makeFunctionSource({2, 2, 2}, [](Int3 c) {
          return c.y == 1 || c.x == 0 ? 1u : 0u;
        }));
    const Oracle oracle = *Oracle::of(coarse->volume);
    for (const char *traversal : {"stack", "restart", "unrolled"}) {
      Format traversed = format;
      for (Level &level : traversed.levels)
        level.setAttribute(kTraversalAttribute, traversal);
      const auto rays = raysFromOutside({32, 32, 32}, 2000);
      const auto hits = hitsOf(built->volume, traversed, "cone", 1e6f, rays);
      std::size_t differences = 0;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        Ray scaled = rays[i];
        for (float &coordinate : scaled.origin)
          coordinate /= 16;
        const Hit exact = oracle.trace(scaled);
        bool same = exact.isHit() == hits[i].isHit();
        for (int axis = 0; same && exact.isHit() && axis < 3; ++axis)
          same = hits[i].voxel[axis] >> 4 == exact.voxel[axis];
        differences += !same;
        ASSERT_TRUE(!hits[i].isHit() || hits[i].rgba == 0xff00ffffu) << text;
      }
      // Rounding at a boundary may tell a ray another child.
      EXPECT_LE(differences, 2u) << text << " " << traversal << " of " << rays.size();
    }
  }
}

TEST_F(DetailKernels, GiveTheSameHitsWithEveryTraversalAndAddressing) {
  const Format stack = *parseFormat("S(2) D(1^3, 2) G(3)");
  Format restart = stack, unrolled = stack;
  for (Level &level : restart.levels)
    level.setAttribute(kTraversalAttribute, "restart");
  for (Level &level : unrolled.levels)
    level.setAttribute(kTraversalAttribute, "unrolled");
  const auto built = Constructor::compile(stack)->build(*test::hardScenes(stack.extent())[7].source());
  const auto rays = verifyRays(stack.extent(), 10000, 3);
  const auto full = hitsOf(built->volume, stack, "full", 0, rays);
  for (const float spread : {0.01f, 0.05f, 0.2f, 3.0f}) {
    const auto hits = hitsOf(built->volume, stack, "cone", spread, rays);
    EXPECT_FALSE(areSame(hits, full)) << spread;
    EXPECT_TRUE(areSame(hits, hitsOf(built->volume, restart, "cone", spread, rays))) << spread;
    EXPECT_TRUE(areSame(hits, hitsOf(built->volume, unrolled, "cone", spread, rays))) << spread;
    EXPECT_TRUE(areSame(hits, hitsOf(built->volume, stack, "cone", spread, rays, Addressing::Segments)))
        << spread;
  }
}

TEST_F(DetailKernels, NeverStopBehindTheExactHitNorMissIt) {
  const Format format = *parseFormat("R(1^3) G(4)");
  const auto built = Constructor::compile(format)->build(*test::hardScenes(format.extent())[6].source());
  const auto rays = raysFromOutside(format.extent(), 4000);
  const auto full = hitsOf(built->volume, format, "full", 0, rays);
  const auto coarse = hitsOf(built->volume, format, "cone", 0.05f, rays);
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (full[i].isHit()) {
      ASSERT_TRUE(coarse[i].isHit()) << i;
      ASSERT_LE(coarse[i].t, full[i].t) << i;
    }
}

} // namespace
} // namespace voxc
