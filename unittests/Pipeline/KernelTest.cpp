// Generated kernels against the oracle, for every format, traversal and addressing.
#include "TestLength.h"

#include "testing/HardRays.h"
#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Emit/Emit.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Source/Sources.h"
#include "voxc/Trace/Tracer.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <string>

namespace voxc {
namespace {

/// Rays of every hard class, `count` of each.
std::vector<Ray> everyHardRay(Int3 extent, std::size_t count, std::uint64_t seed) {
  std::vector<Ray> rays;
  for (const test::HardRayClass &row : test::hardRayClasses()) {
    const std::vector<Ray> more = test::hardRays(extent, row.name, count, seed);
    rays.insert(rays.end(), more.begin(), more.end());
  }
  return rays;
}

/// The software device, on which these figures were found; others are not tested here.
class Kernels : public ::testing::Test {
protected:
  static void SetUpTestSuite() {
    if (auto device = Device::open("llvmpipe"))
      device_ = new Device(std::move(*device));
  }
  static void TearDownTestSuite() {
    delete device_;
    device_ = nullptr;
  }
  void SetUp() override {
    if (!device_)
      GTEST_SKIP() << "there is no llvmpipe device";
  }

  static std::vector<Hit> hitsOf(const Volume &volume, const Format &format, Addressing addressing,
                                 std::span<const Ray> rays) {
    auto tracer = createTracer(*device_, kernelOf(format, addressing), volume);
    EXPECT_TRUE(tracer) << tracer.error().message;
    std::vector<Hit> hits(rays.size());
    const auto report = (*tracer)->trace(rays, hits);
    EXPECT_TRUE(report) << report.error().message;
    return hits;
  }

  /// Exact kernels agree with the oracle to the last bit; fast ones differ from it by float rounding at a
  /// cell's boundary alone, and rarely.
  static void expectHits(const Format &format, const test::HardScene &scene, Addressing addressing,
                         std::uint64_t seed) {
    const auto constructor = Constructor::compile(format);
    ASSERT_TRUE(constructor) << constructor.error().message;
    const auto built = constructor->build(*scene.source());
    ASSERT_TRUE(built) << built.error().message;
    const bool fast = format.attributes.value(kPrecisionAttribute) == "fast";
    const auto rays = fast ? verifyRays(scene.extent, 2000, seed) : everyHardRay(scene.extent, 150, seed);
    const auto hits = hitsOf(built->volume, format, addressing, rays);
    const ErrorFigures figures = compare(*Oracle::of(built->volume), rays, hits);
    const std::uint64_t wrong = figures.missed + figures.ghost + figures.wrong;
    const std::string what = printIr(format) + scene.name + ", ray " +
                             std::to_string(figures.examples.empty() ? 0 : figures.examples[0]);
    EXPECT_EQ(figures.colour, 0u) << what;
    EXPECT_EQ(wrong, fast ? figures.boundary : 0) << what;
    EXPECT_LE(wrong, 20u) << what;
    EXPECT_TRUE(fast || figures.maxUlpDt == 0) << what;
  }

  /// Compiled once for all scenes.
  static const Kernel &kernelOf(const Format &format, Addressing addressing) {
    static std::map<std::string, Kernel> kernels;
    const std::string key = std::string(toString(addressing)) + printIr(format);
    if (!kernels.contains(key)) {
      auto kernel = compileKernel(format, {addressing});
      EXPECT_TRUE(kernel) << kernel.error().message;
      kernels.emplace(key, std::move(*kernel));
    }
    return kernels.at(key);
  }

  static Device *device_;
};

Device *Kernels::device_ = nullptr;

TEST_F(Kernels, AgreeWithTheOracleOnBaseFormats) {
  for (const char *text : {"R(4^3)", "D(4^3, 6)", "S(4)", "G(4)", "R(2,3,1)", "D(1,4,2,9)", "S(0)", "G(0)"}) {
    const Format format = *parseFormat(text);
    for (const test::HardScene &scene : test::hardScenes(format.extent()))
      expectHits(format, scene, Addressing::Buffer, 1);
  }
}

TEST_F(Kernels, DifferFromTheOracleByRoundingAloneIfTheyAreFast) {
  for (const char *text : {"R(4^3)", "D(4^3, 6)", "S(4)", "G(4)", "R(2,3,1)", "D(1,4,2,9)"}) {
    Format format = *parseFormat(text);
    format.setAttribute(kPrecisionAttribute, "fast");
    for (const std::size_t scene : {3u, 5u, 6u, 7u})
      expectHits(format, test::hardScenes(format.extent())[scene], Addressing::Buffer, 1);
  }
}

TEST_F(Kernels, AgreeWithTheOracleOnRandomFormats) {
  std::mt19937 random(11);
  for (int i = 0; i < test::rounds(10); ++i) {
    Format format = test::randomFormat(random, test::pick(random, 4, 6));
    const auto scenes = test::hardScenes(format.extent());
    const auto addressing =
        std::array{Addressing::Buffer, Addressing::Segments, Addressing::Texels}[random() % 3];
    expectHits(format, scenes[random() % scenes.size()], addressing, random());
    format.setAttribute(kPrecisionAttribute, "fast");
    expectHits(format, scenes[random() % scenes.size()], addressing, random());
  }
}

TEST_F(Kernels, GiveTheSameHitsWithEveryTraversalAndAddressing) {
  const Format format = *parseFormat("S(2) D(1^3, 2) G(3)");
  const test::HardScene scene = test::hardScenes(format.extent())[6];
  const auto built = Constructor::compile(format)->build(*scene.source());
  const auto rays = verifyRays(scene.extent, 20000, 3);
  const auto stack = hitsOf(built->volume, format, Addressing::Buffer, rays);
  const auto segments = hitsOf(built->volume, format, Addressing::Segments, rays);
  const auto bytes = stack.size() * sizeof(Hit);
  for (const char *pass : {"restart-sv", "unroll-sv"}) {
    Format traversed = format;
    Diagnostics diagnostics;
    ASSERT_EQ(findPass(pass)->run(traversed, diagnostics), PassResult::Changed);
    const auto hits = hitsOf(built->volume, traversed, Addressing::Buffer, rays);
    EXPECT_EQ(std::memcmp(stack.data(), hits.data(), bytes), 0);
  }
  EXPECT_EQ(std::memcmp(stack.data(), segments.data(), bytes), 0);
}

TEST_F(Kernels, FinishTraversalsThatTheDeviceCutsShort) {
  // Llvmpipe ends every loop of an invocation after 65535 turns in all.
  for (const char *text : {"R(18,0,0)", "R(16,0,0) S(2)", "D(18,0,0,1)", "R(16,0,0) G(2)"}) {
    const Format format = *parseFormat(text);
    const Int3 extent = format.extent();
    const auto built = Constructor::compile(format)->build(
        *makeFunctionSource(extent, [](Int3 c) { return c.x == 3 || (c.x % 5 == 4 && c.y > 0) ? 9u : 0u; }));
    ASSERT_TRUE(built) << built.error().message;
    const std::vector<Ray> rays(100, Ray{{300000.0f, 0.5f, 0.5f}, {-1.0f, 0.0f, 0.0f}});
    for (const Hit &hit : hitsOf(built->volume, format, Addressing::Buffer, rays)) {
      ASSERT_EQ(hit.voxel[0], 3) << text;
      ASSERT_EQ(hit.t, 300000.0f - 4.0f) << text;
    }
  }
}

TEST_F(Kernels, FitOnlyTheStorageTheyWereMadeFor) {
  const Format format = *parseFormat("R(1^3) G(2)");
  const auto built = Constructor::compile(format)->build(**makeBuiltinSource("full", 8));
  const auto other = compileKernel(*parseFormat("R(2^3) G(1)"));
  const auto refused = createTracer(*device_, *other, built->volume);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::Input);
  const auto restart =
      compileKernel(*parseFormat("format { level 1: raw(1,1,1) level 2: svdag(2) traversal=restart }"));
  EXPECT_TRUE(createTracer(*device_, *restart, built->volume)) << "a traversal does not change storage";
}

TEST(Kernel, IsValidForEveryBaseFormatAndOptimised) {
  for (const char *text : {"R(4^3)", "D(4^3, 6)", "S(4)", "G(4)", "R(1^3) S(1) D(1^3,2) G(1)"})
    for (const bool optimise : {false, true})
      for (const Addressing addressing : {Addressing::Buffer, Addressing::Segments, Addressing::Texels}) {
        const auto kernel =
            compileKernel(*parseFormat(text), {.addressing = addressing, .optimise = optimise});
        ASSERT_TRUE(kernel) << kernel.error().message;
        const auto read = Kernel::fromSpirv(kernel->spirv);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->storageDigest, storageDigest(*parseFormat(text)));
        EXPECT_EQ(read->addressing, addressing);
      }
}

} // namespace
} // namespace voxc
