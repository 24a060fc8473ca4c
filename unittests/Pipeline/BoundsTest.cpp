// Rays with bounds: what kernels find between two moments, on every device, to the bit.
#include "BuiltScene.h"
#include "DeviceTesting.h"
#include "TestLength.h"

#include "testing/HardRays.h"
#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Kernel/OpenTracer.h"
#include "voxc/Oracle/VerifyRays.h"
#include "voxc/Trace/PagedTracer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

namespace voxc {
namespace {

using test::textOf;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

constexpr Question kBoundedQuestions[] = {{Query::Closest, {}, true},
                                          {Query::Closest, {.face = true}, true},
                                          {Query::Any, outputsOf(Query::Any), true},
                                          {Query::Distance, outputsOf(Query::Distance), true}};

constexpr const char *kKinds[] = {
    "R(4^3)",
    "D(4^3, 6)",
    "S(4)",
    "G(4, 2)",
    "M(2^3) M(2^3)",
    "H(2^3) H(2^3)",
    "S(0)",
    "format { level 1: svdag(4) traversal=restart }",
    "format { level 1: svo(3) traversal=unrolled level 2: raw(1, 1, 1) }",
    "format levels=flat { level 1: svdag(2) level 2: distance(2, 2, 2, 5) }",
    ("format levels=direct { level 1: distance(2, 2, 2, 15) distances=in-slot metric=octant level 2: "
     "masked(2, 2, 2) }"),
    "format granule=4 { level 1: raw(2, 2, 2) level 2: svdag(2) }",
    "format values=apart { level 1: svdag(1) level 2: masked(3, 3, 3) }"};

Format asking(Format format, const Question &question) {
  format.setAttribute(kQueryAttribute, toString(question.query));
  format.setAttribute(kFaceAttribute, question.outputs.face ? "yes" : "no");
  format.setAttribute(kBoundsAttribute, question.bounds ? "yes" : "no");
  return format;
}

std::string textOf(const BoundedRay &ray) {
  std::string text = "ray";
  for (const float number : {ray.origin[0], ray.origin[1], ray.origin[2], ray.direction[0], ray.direction[1],
                             ray.direction[2], ray.tmin, ray.tmax}) {
    char digits[40];
    std::snprintf(digits, sizeof digits, " %a", double{number});
    text += digits;
  }
  return text;
}

/// Rays of every hard class, with bounds.
std::vector<BoundedRay> raysThrough(const Oracle &oracle, Int3 extent, std::size_t count,
                                    std::uint64_t seed) {
  const std::vector<Int3> voxels = oracle.sampleVoxels(64);
  std::vector<Ray> rays = verifyRays(extent, 4 * count, seed);
  for (const test::HardRayClass &row : test::hardRayClasses()) {
    const std::vector<Ray> more = test::hardRays({extent, voxels}, row.name, count, seed);
    rays.insert(rays.end(), more.begin(), more.end());
  }
  return withHardBounds(oracle, rays, seed);
}

class Bounds : public test::OnDevice {
protected:
  /// As the oracle answers, to the bit.
  void expectAnswers(const Volume &volume, const Format &format, const Oracle &oracle, RaySpan rays,
                     const Question &question) {
    const Format asked = asking(format, question);
    const auto tracer = tracerOf(volume, asked);
    ASSERT_TRUE(tracer) << tracer.error().message;
    std::vector<Hit> hits(rays.size());
    const auto report = (*tracer)->trace(rays, hits);
    ASSERT_TRUE(report) << report.error().message;
    std::size_t found = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Hit exact = oracle.answer(rays[i], question, rays.bounds(i));
      found += exact.isHit();
      ASSERT_EQ(std::memcmp(&hits[i], &exact, sizeof exact), 0)
          << printIr(asked) << textOf(bounded(rays[i], rays.bounds(i))) << "\n"
          << textOf(hits[i]) << ", and not " << textOf(exact);
    }
    RecordProperty("found", static_cast<int>(found));
  }
};

TEST_P(Bounds, AreKeptExactlyInEveryKindOfLevel) {
  std::uint64_t seed = 1;
  for (const char *text : kKinds) {
    const Format format = *parseFormat(text);
    const auto scenes = test::hardScenes(format.extent());
    const Volume volume = test::builtScene(format, scenes[(seed * 5) % scenes.size()]);
    const Oracle oracle = *Oracle::of(volume);
    const auto rays = raysThrough(oracle, format.extent(), test::rounds(30), seed);
    expectAnswers(volume, format, oracle, rays, kBoundedQuestions[seed++ % std::size(kBoundedQuestions)]);
  }
}

TEST_P(Bounds, AreKeptExactlyInRandomFormats) {
  std::mt19937 random(17);
  for (int i = 0; i < test::rounds(5); ++i) {
    const Format format = test::randomFormat(random, test::pick(random, 3, 6));
    const auto scenes = test::hardScenes(format.extent());
    const Volume volume = test::builtScene(format, scenes[random() % scenes.size()]);
    const Oracle oracle = *Oracle::of(volume);
    const auto rays = raysThrough(oracle, format.extent(), 60, random());
    expectAnswers(volume, format, oracle, rays, kBoundedQuestions[i % std::size(kBoundedQuestions)]);
  }
}

/// A solid of which most voxels are entered before tmin, and a traversal of many steps to it.
TEST_P(Bounds, AreKeptExactlyInDeepSolids) {
  const Format format = *parseFormat("R(2^3) G(8)");
  const test::HardScene full{"full", [](Int3) { return 0xff336699u; }, {}, format.extent()};
  const Volume volume = test::builtScene(format, full);
  const Oracle oracle = *Oracle::of(volume);
  std::vector<BoundedRay> rays;
  for (const Ray &ray : verifyRays(format.extent(), 2000, 3))
    rays.push_back(bounded(ray, {100.0f + 0.37f * static_cast<float>(rays.size() % 1000), 700.0f}));
  expectAnswers(volume, format, oracle, rays, kBoundedQuestions[1]);
}

/// From 2^20 edges away float32 numbers are 8 voxels apart.
TEST_P(Bounds, AreWhereTraversalsBeginFromFarAway) {
  const Format format = *parseFormat("R(2^3) G(4)");
  const test::HardScene full{"full", [](Int3) { return 0xff336699u; }, {}, format.extent()};
  const Volume volume = test::builtScene(format, full);
  const Oracle oracle = *Oracle::of(volume);
  const float away = std::ldexp(64.0f, 20);
  std::vector<BoundedRay> rays;
  for (int i = 0; i < 200; ++i)
    rays.push_back({{0.3f * static_cast<float>(i), 31.7f, -away},
                    away + 32,
                    {std::ldexp(static_cast<float>(i % 5 - 2), -28), 0, 1},
                    away + static_cast<float>(8 * (i % 8))});
  expectAnswers(volume, format, oracle, rays, kBoundedQuestions[0]);
  std::vector<Hit> hits(rays.size());
  ASSERT_TRUE((*tracerOf(volume, asking(format, kBoundedQuestions[0])))
                  ->trace(std::span<const BoundedRay>(rays), hits, {.countSteps = true}));
  EXPECT_LE(std::ranges::max(hits, {}, &Hit::steps).steps, 12u); // 68 from the entry on.
}

TEST_P(Bounds, AreKeptByFastKernelsButForRounding) {
  Format format = *parseFormat("R(1^3) S(1) G(3)");
  format.setAttribute(kPrecisionAttribute, "fast");
  const Volume volume = test::builtScene(format, test::hardScenes(format.extent())[6]);
  const Oracle oracle = *Oracle::of(volume);
  std::vector<BoundedRay> rays;
  for (const Ray &ray : verifyRays(format.extent(), 3000, 5))
    rays.push_back(bounded(ray, {3.0f + 0.01f * static_cast<float>(rays.size()), 200.0f}));
  const Format asked = asking(format, kBoundedQuestions[0]);
  const auto tracer = tracerOf(volume, asked);
  ASSERT_TRUE(tracer) << tracer.error().message;
  std::vector<Hit> hits(rays.size());
  ASSERT_TRUE((*tracer)->trace(rays, hits));
  EXPECT_LT(compare(oracle, rays, hits).differences(), 30u);
}

TEST_P(Bounds, OfRaysWithoutAnyAreAllThatThereIs) {
  const Format format = *parseFormat("R(2^3) G(3)");
  const Volume volume = test::builtScene(format, test::hardScenes(format.extent())[7]);
  const auto rays = verifyRays(format.extent(), 40000, 9);
  std::vector<Hit> plain(rays.size()), bound(rays.size());
  ASSERT_TRUE((*tracerOf(volume, format))->trace(rays, plain));
  ASSERT_TRUE((*tracerOf(volume, asking(format, kBoundedQuestions[0])))
                  ->trace(rays, bound, {.order = RayOrder::Binned}));
  EXPECT_EQ(std::memcmp(plain.data(), bound.data(), plain.size() * sizeof(Hit)), 0);
  ASSERT_TRUE((*tracerOf(volume, asking(format, kBoundedQuestions[0])))->trace(std::span<const Ray>(), {}));
}

TEST_P(Bounds, AreRefusedByKernelsWithout) {
  const Format format = *parseFormat("G(3)");
  const Volume volume = test::builtScene(format, test::hardScenes(format.extent())[1]);
  const BoundedRay ray{{-1, 1, 1}, 0, {1, 0, 0}, 3};
  Hit hit;
  const auto traced = (*tracerOf(volume, format))->trace(std::span(&ray, 1), std::span(&hit, 1));
  ASSERT_FALSE(traced);
  EXPECT_EQ(traced.error().kind, ErrorKind::Usage);
  EXPECT_THAT(traced.error().message, ::testing::HasSubstr("compiled for rays without"));
}

TEST_P(Bounds, GoOnInVolumesOfWhichPagesAreThere) {
  std::mt19937 random(23);
  const std::string path = testing::TempDir() + "voxc-bounds-" + std::to_string(::getpid()) + ".hvx";
  for (const char *text : {"G(5)", "format values=apart { level 1: raw(2, 2, 2) level 2: svdag(3) }"}) {
    const Format format = asking(*parseFormat(text), kBoundedQuestions[1]);
    const Volume volume = test::builtScene(*parseFormat(text), test::hardScenes(format.extent())[7]);
    const Oracle oracle = *Oracle::of(volume);
    ASSERT_TRUE(volume.save(path, {.compress = true, .pageBytes = 4096}));
    const auto paged = PagedVolume::open(path);
    ASSERT_TRUE(paged);
    const auto rays = raysThrough(oracle, format.extent(), 20, random());
    std::vector<Hit> hits(rays.size());
    auto tracer =
        device_ ? createPagedTracer(*device_, *compileKernel(format, {.addressing = Addressing::Paged}),
                                    *paged, {leastPagingBytes(*paged), 2})
                : createPagedCpuTracer(
                      *compileCpuKernel(format, {.addressing = Addressing::Paged, .start = CpuStart::Fast}),
                      *paged, {leastPagingBytes(*paged), 2});
    ASSERT_TRUE(tracer) << tracer.error().message;
    ASSERT_TRUE((*tracer)->trace(rays, hits));
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Hit exact = oracle.answer(rays[i].ray(), kBoundedQuestions[1], rays[i].bounds());
      ASSERT_EQ(std::memcmp(&hits[i], &exact, sizeof exact), 0)
          << text << " " << textOf(rays[i]) << ": " << textOf(hits[i]) << ", and not " << textOf(exact);
    }
  }
  std::filesystem::remove(path);
}

INSTANTIATE_TEST_SUITE_P(On, Bounds, ::testing::Values("cpu", "llvmpipe"), test::deviceName);

TEST(BoundedRay, GoesAlone) {
  const Format format = asking(*parseFormat("G(3)"), kBoundedQuestions[1]);
  const Volume volume = test::builtScene(*parseFormat("G(3)"), test::hardScenes(format.extent())[1]);
  const CpuKernel kernel = *compileCpuKernel(format, {.start = CpuStart::Fast});
  const auto at = [&](float tmin, float tmax) {
    return *intersect(volume, kernel, BoundedRay{{-1, 1, 1}, tmin, {1, 0, 0}, tmax});
  };
  EXPECT_EQ(at(0, kInfinity).t, 1.0f);
  EXPECT_EQ(at(0, kInfinity).steps, 0u);
  EXPECT_EQ(at(1.5f, 2).voxel[0], 1);
  EXPECT_FALSE(at(1.5f, 1.75f).isHit());
  EXPECT_TRUE(intersect(volume, kernel, Ray{{-1, 1, 1}, {1, 0, 0}})->isHit());
  EXPECT_FALSE(intersect(volume, *compileCpuKernel(*parseFormat("G(3)")), BoundedRay{}));
}

TEST(BoundedRay, HasNoPlaceInQuestionsOfPointsAndCones) {
  EXPECT_FALSE(parseFormat("format bounds=yes query=occupancy { level 1: svdag(3) }"));
  EXPECT_FALSE(parseFormat("format bounds=yes detail=cone { level 1: svdag(3) }"));
  EXPECT_TRUE(parseFormat("format bounds=yes query=any { level 1: svdag(3) }"));
}

} // namespace
} // namespace voxc
