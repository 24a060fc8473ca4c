// Kernels on this processor: the hits of Vulkan's, bit for bit, and those of the oracle.
#include "GuardedVolume.h"
#include "TestLength.h"

#include "Jit/Jit.h"
#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Oracle/VerifyRays.h"
#include "voxc/Passes/Pass.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <map>
#include <string>
#include <thread>

namespace voxc {
namespace {

constexpr const char *kBaseFormats[] = {"R(4^3)",     "D(4^3, 6)", "S(4)", "G(4)",     "R(2,3,1)",
                                        "D(1,4,2,9)", "S(0)",      "G(0)", "R(1,0,2)", "D(2^3,2) G(2)"};

/// What `compile` gives for the format, remembered for the next scene.
template <typename Compile> auto compiledOnce(const Format &format, Compile compile) {
  static std::map<std::string, std::decay_t<decltype(*compile())>> known;
  const std::string key = printIr(format);
  if (!known.contains(key)) {
    auto kernel = compile();
    EXPECT_TRUE(kernel) << kernel.error().message;
    known.emplace(key, std::move(*kernel));
  }
  return known.at(key);
}

/// Lavapipe's arithmetic is that of this processor, so that all bits can be compared, of fast kernels too.
constexpr KernelOptions kLikeTheCpu = {.arithmetic = Arithmetic::Ieee};

class CpuKernels : public ::testing::Test {
protected:
  /// Kernels read nothing that is behind the words.
  static Expected<Volume> build(const Format &format, const test::HardScene &scene) {
    const auto constructor = Constructor::compile(format);
    if (!constructor)
      return constructor.error();
    auto built = constructor->build(*scene.source());
    if (!built)
      return built.error();
    return test::guarded(built->volume);
  }

  static std::vector<Hit> traced(Expected<std::unique_ptr<Tracer>> tracer, std::span<const Ray> rays,
                                 bool countSteps) {
    EXPECT_TRUE(tracer) << tracer.error().message;
    std::vector<Hit> hits(rays.size());
    const auto report = (*tracer)->trace(rays, hits, {.countSteps = countSteps});
    EXPECT_TRUE(report) << report.error().message;
    return hits;
  }

  static std::vector<Hit> cpuHits(const Volume &volume, const Format &format, std::span<const Ray> rays,
                                  bool countSteps = false) {
    const auto kernel =
        compiledOnce(format, [&] { return compileCpuKernel(format, {.start = CpuStart::Fast}); });
    return traced(createCpuTracer(kernel, volume, 2), rays, countSteps);
  }

  /// The hits must come out alike, and the lookups too where no step is resolved; a device of lanes resolves
  /// outside of the traversal, and then looks again. Nothing to compare without llvmpipe.
  static void expectVulkansHits(const Volume &volume, const Format &format, std::span<const Ray> rays,
                                const std::string &what) {
    auto device = Device::open("llvmpipe");
    if (!device)
      return;
    const auto kernel = compiledOnce(format, [&] { return compileKernel(format, kLikeTheCpu); });
    const auto theirs = traced(createTracer(*device, kernel, volume), rays, true);
    const auto ours = cpuHits(volume, format, rays, true);
    const bool resolves = format.attributes.value(kPrecisionAttribute) == "exact";
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const std::string where = what + ", ray " + std::to_string(i);
      ASSERT_EQ(std::memcmp(&ours[i], &theirs[i], offsetof(Hit, steps)), 0)
          << where << ": t = " << ours[i].t << " and " << theirs[i].t;
      ASSERT_LE(ours[i].steps, theirs[i].steps) << where;
      ASSERT_TRUE(resolves || ours[i].steps == theirs[i].steps) << where << ": " << ours[i].steps;
    }
  }

  static void expectSameHitsOfAllTraversals(const Format &format, const test::HardScene &scene,
                                            std::size_t count) {
    const auto volume = build(format, scene);
    ASSERT_TRUE(volume) << volume.error().message;
    const auto rays = verifyRays(scene.extent, count, 3);
    const auto stack = cpuHits(*volume, format, rays);
    for (const char *pass : {"restart-sv", "unroll-sv"}) {
      Format traversed = format;
      Diagnostics diagnostics;
      ASSERT_EQ(findPass(pass)->run(traversed, diagnostics), PassResult::Changed);
      const auto hits = cpuHits(*volume, traversed, rays);
      EXPECT_EQ(std::memcmp(stack.data(), hits.data(), stack.size() * sizeof(Hit)), 0) << scene.name;
    }
  }

  static void expectHits(Format format, const test::HardScene &scene, std::uint64_t seed) {
    const auto volume = build(format, scene);
    ASSERT_TRUE(volume) << volume.error().message;
    const auto rays = verifyRays(scene.extent, 2000, seed);
    const auto oracle = Oracle::of(*volume);
    const ErrorFigures exact = compare(*oracle, rays, cpuHits(*volume, format, rays));
    EXPECT_TRUE(exact.clean()) << printIr(format) << scene.name;
    expectVulkansHits(*volume, format, rays, printIr(format) + scene.name);

    format.setAttribute(kPrecisionAttribute, "fast");
    const ErrorFigures fast = compare(*oracle, rays, cpuHits(*volume, format, rays));
    EXPECT_EQ(fast.missed + fast.ghost + fast.wrong, fast.boundary) << printIr(format) << scene.name;
    expectVulkansHits(*volume, format, rays, printIr(format) + scene.name);
  }
};

TEST_F(CpuKernels, GiveTheHitsOfVulkanAndTheOracleOnBaseFormats) {
  for (const char *text : kBaseFormats) {
    const Format format = *parseFormat(text);
    const auto scenes = test::hardScenes(format.extent());
    for (const std::size_t scene : {5u, 7u})
      expectHits(format, scenes[scene], scene);
  }
}

TEST_F(CpuKernels, GiveTheHitsOfVulkanAndTheOracleOnRandomFormats) {
  std::mt19937 random(17);
  for (int i = 0; i < test::rounds(6); ++i) {
    const Format format = test::randomFormat(random, test::pick(random, 4, 6));
    const auto scenes = test::hardScenes(format.extent());
    expectHits(format, scenes[random() % scenes.size()], random());
  }
}

TEST_F(CpuKernels, ReadNothingBehindValuesThatAreAllAlike) {
  Format format = *parseFormat("M(2^3) M(2^3)");
  Diagnostics diagnostics;
  ASSERT_EQ(findPass("values-apart")->run(format, diagnostics), PassResult::Changed);
  expectHits(format, {"full", [](Int3) { return 0xff302010u; }, {}, format.extent()}, 5);
}

TEST_F(CpuKernels, GiveTheSameHitsWithEveryTraversal) {
  const Format format = *parseFormat("S(2) D(1^3, 2) G(3)");
  expectSameHitsOfAllTraversals(format, test::hardScenes(format.extent())[6], 20000);
}

TEST_F(CpuKernels, TraverseLeavesThatStandForManySubVolumes) {
  // Equal sub-volumes are one, so that eight leaves collapse above them too.
  const Format format = *parseFormat("format { level 1: svdag(2) level 2: svdag(2) dedup=level }");
  for (const test::HardScene &scene : test::hardScenes(format.extent()))
    expectSameHitsOfAllTraversals(format, scene, 2000);
}

TEST_F(CpuKernels, FinishTraversalsThatLlvmpipeWouldCutShort) {
  const Format format = *parseFormat("R(18,0,0)");
  const auto volume = build(format, {"", [](Int3 c) { return c.x == 3 ? 9u : 0u; }, {}, format.extent()});
  ASSERT_TRUE(volume) << volume.error().message;
  const std::vector<Ray> rays = {{{262143.5f, 0.5f, 0.5f}, {-1.0f, 0.0f, 0.0f}}};
  const auto hits = cpuHits(*volume, format, rays);
  EXPECT_EQ(hits[0].voxel[0], 3);
  EXPECT_EQ(hits[0].t, 262143.5f - 4.0f);
}

/// The hits with the words read as their steps; `tracer` must be able to count them.
std::vector<Hit> countedWords(Expected<std::unique_ptr<Tracer>> tracer, std::span<const Ray> rays) {
  EXPECT_TRUE(tracer) << tracer.error().message;
  std::vector<Hit> hits(rays.size());
  const auto report = (*tracer)->trace(rays, hits, {.countWords = true});
  EXPECT_TRUE(report) << report.error().message;
  return hits;
}

/// Processors whose kernels this one can run, one for each number of lanes.
std::vector<std::string> processorsByLanes() {
#ifdef __x86_64__
  std::vector<std::string> processors = {"x86-64"};
  if (__builtin_cpu_supports("x86-64-v3"))
    processors.emplace_back("x86-64-v3");
  if (__builtin_cpu_supports("x86-64-v4"))
    processors.emplace_back("x86-64-v4");
  return processors;
#else
  return {"generic"};
#endif
}

TEST_F(CpuKernels, AreExactWithAnyNumberOfLanes) {
  const Format format = *parseFormat("D(1^3, 3) S(2) M(1^3)");
  const test::HardScene scene = test::hardScenes(format.extent())[7];
  const auto volume = build(format, scene);
  ASSERT_TRUE(volume) << volume.error().message;
  const auto oracle = Oracle::of(*volume);
  for (const std::string &processor : processorsByLanes()) {
    const auto object = compileCpuObject(format, {.processor = processor});
    ASSERT_TRUE(object) << object.error().message;
    const auto code = JitCode::link(*object);
    ASSERT_TRUE(code) << code.error().message;
    const CpuKernel kernel{reinterpret_cast<CpuKernel::Function>(*code->find("voxc_intersect")),
                           storageDigest(format)};
    // One ray, packets that are not full, and more than a batch.
    for (const std::size_t count : {1, 37, 5000}) {
      const auto rays = verifyRays(scene.extent, count, 5);
      EXPECT_TRUE(compare(*oracle, rays, traced(createCpuTracer(kernel, *volume, 1), rays, false)).clean())
          << processor << ", " << count << " rays";
    }
  }
}

TEST_F(CpuKernels, CountTheWordsThatVulkansRead) {
  Format format = *parseFormat("R(1^3) G(3)");
  format.setAttribute(kPrecisionAttribute, "fast"); // No step is resolved, after which words are read again.
  const test::HardScene scene = test::hardScenes(format.extent())[7];
  const auto volume = build(format, scene);
  ASSERT_TRUE(volume) << volume.error().message;
  const auto rays = verifyRays(scene.extent, 2000, 11);
  const auto words = countedWords(
      createCpuTracer(*compileCpuKernel(format, {.countWords = true, .start = CpuStart::Fast}), *volume, 2),
      rays);
  const auto plain = cpuHits(*volume, format, rays, true);
  std::uint64_t lookups = 0, read = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(words[i].t, plain[i].t);
    lookups += plain[i].steps;
    read += words[i].steps;
  }
  EXPECT_GT(read, lookups) << "a lookup in a tree below a grid reads several words";
  EXPECT_LT(read, 10 * lookups);
  if (auto device = Device::open("llvmpipe"); device) {
    EXPECT_EQ(
        std::memcmp(
            countedWords(createTracer(*device, *compileKernel(format, kLikeTheCpu), *volume), rays).data(),
            words.data(), words.size() * sizeof(Hit)),
        0);
  }
}

TEST_F(CpuKernels, CountAWordForEachCellOfAGridAlsoWhereTraversalsAreCutShort) {
  const Format format = *parseFormat("R(18,0,0)");
  const auto volume = build(format, {"", [](Int3 c) { return c.x == 3 ? 9u : 0u; }, {}, format.extent()});
  ASSERT_TRUE(volume) << volume.error().message;
  const std::vector<Ray> rays = {{{262143.5f, 0.5f, 0.5f}, {-1.0f, 0.0f, 0.0f}}};
  const auto hits = countedWords(
      createCpuTracer(*compileCpuKernel(format, {.countWords = true, .start = CpuStart::Fast}), *volume),
      rays);
  EXPECT_EQ(hits[0].steps, 262143u - 3 + 1 + 1) << "the cells, and the root's offset once";
  if (auto device = Device::open("llvmpipe"); device) {
    const auto theirs =
        countedWords(createTracer(*device, *compileKernel(format, kLikeTheCpu), *volume), rays);
    EXPECT_GE(theirs[0].steps, hits[0].steps);
    EXPECT_LE(theirs[0].steps, hits[0].steps + 16) << "the root's offset and a cell again in each dispatch";
  }
}

TEST_F(CpuKernels, CountWordsOnlyIfTheyWereMadeToDoSo) {
  const Format format = *parseFormat("G(2)");
  const auto volume = build(format, test::hardScenes(format.extent())[1]);
  ASSERT_TRUE(volume) << volume.error().message;
  for (const bool counts : {false, true}) {
    const auto tracer = createCpuTracer(*compileCpuKernel(format, {.countWords = counts}), *volume);
    const std::vector<Ray> rays(1, {{0, 0, 0}, {1, 0, 0}});
    std::vector<Hit> hits(1);
    EXPECT_FALSE((*tracer)->trace(rays, hits, {.countWords = !counts}));
    EXPECT_TRUE((*tracer)->trace(rays, hits, {.countWords = counts}));
  }
}

TEST_F(CpuKernels, AnswerOneRayAtATimeFromAnyThread) {
  const Format format = *parseFormat("R(1^3) G(3)");
  const test::HardScene scene = test::hardScenes(format.extent())[7];
  const auto volume = build(format, scene);
  ASSERT_TRUE(volume) << volume.error().message;
  const auto kernel = compileCpuKernel(format, {.start = CpuStart::Fast});
  ASSERT_TRUE(kernel) << kernel.error().message;
  const auto rays = verifyRays(scene.extent, 2000, 5);
  const auto expected = cpuHits(*volume, format, rays);
  const auto ask = [&](std::vector<Hit> &hits) {
    for (const Ray &ray : rays)
      hits.push_back(*intersect(*volume, *kernel, ray));
  };
  std::vector<Hit> here, there;
  std::jthread other(ask, std::ref(there));
  ask(here);
  other.join();
  for (const auto &hits : {here, there})
    EXPECT_EQ(std::memcmp(hits.data(), expected.data(), expected.size() * sizeof(Hit)), 0);
}

TEST_F(CpuKernels, FitOnlyTheStorageTheyWereMadeFor) {
  const Format format = *parseFormat("R(1^3) G(2)");
  const auto volume = build(format, test::hardScenes(format.extent())[1]);
  ASSERT_TRUE(volume) << volume.error().message;
  const auto other = compileCpuKernel(*parseFormat("R(2^3) G(1)"));
  ASSERT_TRUE(other) << other.error().message;
  const auto refused = createCpuTracer(*other, *volume);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::Input);
  const auto hit = intersect(*volume, *other, Ray{});
  ASSERT_FALSE(hit);
  EXPECT_EQ(hit.error().message, refused.error().message);
  const auto restart =
      compileCpuKernel(*parseFormat("format { level 1: raw(1,1,1) level 2: svdag(2) traversal=restart }"));
  EXPECT_TRUE(createCpuTracer(*restart, *volume)) << "a traversal does not change storage";
}

TEST(CpuObject, IsMadeForAnyProcessorThatClangKnows) {
  const Format format = *parseFormat("G(2)");
  EXPECT_TRUE(compileCpuObject(format));
  EXPECT_TRUE(compileCpuObject(format, {.processor = "native"}));
  const auto unknown = compileCpuObject(format, {.processor = "abacus"});
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message.find("abacus"), std::string::npos) << unknown.error().message;
}

TEST(CpuObject, NeedsANameThatCTakes) {
  for (const char *symbol : {"", "1a", "a-b", "a b"})
    EXPECT_FALSE(compileCpuObject(*parseFormat("G(2)"), {.symbol = symbol})) << symbol;
}

} // namespace
} // namespace voxc
