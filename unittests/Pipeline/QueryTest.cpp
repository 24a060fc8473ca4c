// Kernels that are asked for less, or for faces: what they store of each ray, to the bit.
#include "DeviceTesting.h"
#include "TestLength.h"

#include "testing/HardRays.h"
#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/IR/Query.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Trace/Tracer.h"
#include "voxc/Volume/Attributes.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <map>
#include <string>

namespace voxc {
namespace {

using test::textOf;

constexpr Question kPoint = {Query::Occupancy, outputsOf(Query::Occupancy)};
constexpr Question kQuestions[] = {
    {Query::Any, outputsOf(Query::Any)},
    {Query::Distance, outputsOf(Query::Distance)},
    kPoint,
    {Query::Closest, {.face = true}},
    {Query::Closest, {.colour = false}},
    {Query::Closest, {.voxel = false, .t = false, .face = true, .colour = false}},
    {Query::Closest, {.voxel = false, .t = false}},
};

constexpr const char *kKindsOfSlots[] = {
    "R(4^3)",
    "D(4^3, 6)",
    "S(4)",
    "G(4)",
    "G(4, 2)",
    "M(4^3)",
    "M(2^3) M(2^3)",
    "H(2^3) H(2^3)",
    "S(0)",
    "R(1^3) G(0) M(3^3)",
    "format { level 1: distance(2, 2, 2, 15) distances=in-slot metric=octant level 2: masked(2, 2, 2) }",
    "format payload=occupancy { level 1: svdag(2) level 2: masked(2, 2, 2) }",
    "format values=apart { level 1: raw(2, 2, 2) level 2: svdag(2) }",
    "format values=apart { level 1: svdag(1) level 2: masked(3, 3, 3) }"};

/// A format that asks so.
Format asking(Format format, const Question &question) {
  const auto set = [&](const AttributeKind &kind, bool output) {
    format.setAttribute(kind, output ? "yes" : "no");
  };
  format.setAttribute(kQueryAttribute, toString(question.query));
  if (question.query != Query::Closest)
    return format;
  set(kVoxelAttribute, question.outputs.voxel);
  set(kTAttribute, question.outputs.t);
  set(kFaceAttribute, question.outputs.face);
  set(kColourAttribute, question.outputs.colour);
  set(kIndexAttribute, question.outputs.index);
  return format;
}

/// A device and what it needs; without one, this processor.
class Queries : public test::OnDevice {
protected:
  std::vector<Hit> hitsOf(const Volume &volume, const Format &format, std::span<const Ray> rays,
                          const TraceOptions &options = {}) {
    const auto tracer = tracerOf(volume, format);
    EXPECT_TRUE(tracer) << tracer.error().message;
    std::vector<Hit> hits(rays.size());
    const auto report = (*tracer)->trace(rays, hits, options);
    EXPECT_TRUE(report) << report.error().message;
    return hits;
  }

  /// As the oracle answers, and so in all that its figures compare.
  void expectAnswers(const Volume &volume, const Format &format, std::span<const Ray> rays,
                     std::span<const Question> questions) {
    const auto oracle = Oracle::of(volume);
    for (const Question &question : questions) {
      const Format asked = asking(format, question);
      ASSERT_EQ(questionOf(asked), question);
      const auto hits = hitsOf(volume, asked, rays);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const Hit exact = oracle->answer(rays[i], question);
        ASSERT_EQ(std::memcmp(&hits[i], &exact, sizeof exact), 0)
            << printIr(asked) << "ray " << i << ": " << textOf(hits[i]) << ", and not " << textOf(exact);
      }
      EXPECT_TRUE(compare(*oracle, rays, hits, question).clean()) << printIr(asked);
    }
  }
};

/// Rays of every hard class, `count` of each.
std::vector<Ray> hardRaysOf(Int3 extent, std::size_t count, std::uint64_t seed) {
  std::vector<Ray> rays;
  for (const test::HardRayClass &row : test::hardRayClasses()) {
    const std::vector<Ray> more = test::hardRays(extent, row.name, count, seed);
    rays.insert(rays.end(), more.begin(), more.end());
  }
  return rays;
}

TEST_P(Queries, AreAnsweredAsTheOracleDoes) {
  std::mt19937 random(31);
  for (int i = 0; i < test::rounds(2); ++i) {
    const Format format = test::randomFormat(random, test::pick(random, 4, 6));
    const auto scenes = test::hardScenes(format.extent());
    const auto built = Constructor::compile(format)->build(*scenes[random() % scenes.size()].source());
    ASSERT_TRUE(built) << built.error().message;
    expectAnswers(built->volume, format, hardRaysOf(format.extent(), 60, random()), kQuestions);
  }
}

TEST_P(Queries, AreAnsweredInEveryKindOfSlots) {
  std::size_t next = 0; // Of the other questions, one each.
  for (const char *text : kKindsOfSlots) {
    const Format format = *parseFormat(text);
    const test::HardScene scene = test::hardScenes(format.extent())[7];
    const auto built = Constructor::compile(format)->build(*scene.source());
    ASSERT_TRUE(built) << built.error().message;
    const Question questions[] = {kPoint, kQuestions[next++ % std::size(kQuestions)]};
    expectAnswers(built->volume, format, hardRaysOf(format.extent(), 20, 3), questions);
  }
}

/// A hit as a kernel stores it that is asked for no more than `outputs`, of which faces are none.
Hit reduced(Hit hit, const Outputs &outputs) {
  if (!hit.isHit())
    return hit;
  for (int &coordinate : hit.voxel)
    coordinate = outputs.voxel ? coordinate : 0;
  hit.rgba = outputs.colour ? hit.rgba : 0;
  hit.t = outputs.t ? hit.t : 0;
  return hit;
}

TEST_P(Queries, FindTheHitsOfKernelsThatAreAskedForAll) {
  Format format = *parseFormat("R(1^3) S(1) G(3)");
  const auto built = Constructor::compile(format)->build(*test::hardScenes(format.extent())[6].source());
  const auto rays = verifyRays(format.extent(), 3000, 5);
  const auto expectSame = [&](const TraceOptions &options) {
    const auto all = hitsOf(built->volume, format, rays, options);
    for (const Query query : {Query::Any, Query::Distance}) {
      const auto hits = hitsOf(built->volume, asking(format, {query, outputsOf(query)}), rays, options);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const Hit less = reduced(all[i], outputsOf(query));
        ASSERT_EQ(std::memcmp(&hits[i], &less, sizeof less), 0)
            << printIr(format) << toString(query) << ", ray " << i;
      }
    }
  };
  for (const char *traversal : {"stack", "restart", "unrolled"}) {
    for (Level &level : format.levels)
      level.setAttribute(kTraversalAttribute, traversal);
    format.setAttribute(kDetailAttribute, "cone");
    expectSame({.spread = 0.05f});
    format.setAttribute(kDetailAttribute, "full");
    format.setAttribute(kPrecisionAttribute, "fast");
    expectSame({});
    format.setAttribute(kPrecisionAttribute, "exact");
  }
}

/// The numbers of all voxels, by Morton code.
std::map<std::uint64_t, std::uint32_t> numbersOf(const Volume &volume) {
  std::map<std::uint64_t, std::uint32_t> numbers;
  EXPECT_TRUE(visitVoxels(volume, [&](Int3 voxel, std::uint64_t number) {
    return numbers.emplace(mortonCode(voxel), static_cast<std::uint32_t>(number)).second;
  }));
  return numbers;
}

TEST_P(Queries, TellTheNumbersOfVoxels) {
  for (const char *text : {"format values=apart { level 1: raw(2, 2, 2) level 2: svdag(2) }",
                           "format values=apart { level 1: svdag(1) level 2: masked(3, 3, 3) }",
                           "format values=apart { level 1: raw(3, 1, 2) level 2: masked(1, "
                           "1, 1) level 3: masked(2, 2, 2) }"}) {
    const Format format = *parseFormat(text);
    const auto built = Constructor::compile(format)->build(*test::hardScenes(format.extent())[7].source());
    ASSERT_TRUE(built) << built.error().message;
    const auto numbers = numbersOf(built->volume);
    ASSERT_EQ(numbers.size(), built->volume.info().voxels);
    std::vector<bool> isTaken(numbers.size());
    for (const auto &[code, number] : numbers) {
      ASSERT_LT(number, numbers.size());
      ASSERT_FALSE(isTaken[number]);
      isTaken[number] = true;
    }
    const auto rays = hardRaysOf(format.extent(), 60, 11);
    const auto all = hitsOf(built->volume, format, rays);
    const auto hits =
        hitsOf(built->volume, asking(format, {Query::Closest, {.colour = false, .index = true}}), rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      Hit exact = all[i];
      if (exact.isHit())
        exact.rgba = numbers.at(mortonCode({exact.voxel[0], exact.voxel[1], exact.voxel[2]}));
      ASSERT_EQ(std::memcmp(&hits[i], &exact, sizeof exact), 0)
          << text << ", ray " << i << ": " << textOf(hits[i]) << ", and not " << textOf(exact);
    }
  }
}

TEST_P(Queries, CountLookupsInPlaceOfFaces) {
  const Format format = *parseFormat("R(1^3) G(3)");
  const auto built = Constructor::compile(format)->build(*test::hardScenes(format.extent())[7].source());
  const auto rays = verifyRays(format.extent(), 2000, 7);
  const auto plain = hitsOf(built->volume, format, rays, {.countSteps = true});
  const auto faces =
      hitsOf(built->volume, asking(format, {Query::Closest, {.face = true}}), rays, {.countSteps = true});
  EXPECT_EQ(std::memcmp(plain.data(), faces.data(), plain.size() * sizeof(Hit)), 0);
  for (const Hit &hit : hitsOf(built->volume, asking(format, kPoint), rays, {.countSteps = true}))
    ASSERT_LE(hit.steps, 1u);
}

TEST_P(Queries, LookUpPointsWhereverTheirRaysGo) {
  const Format format = *parseFormat("G(3)");
  const auto built = Constructor::compile(format)->build(*test::hardScenes(format.extent())[1].source());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float tiny = std::numeric_limits<float>::denorm_min();
  const std::vector<Ray> rays = {{{1.5f, 2.5f, 7.999f}, {nan, 0, 0}},
                                 {{-0.0f, tiny, 3}, {0, 0, 0}},
                                 {{-tiny, 1, 1}, {1, 0, 0}},
                                 {{8, 1, 1}, {-1, 0, 0}},
                                 {{nan, 1, 1}, {1, 0, 0}},
                                 {{1e30f, 1, 1}, {1, 0, 0}}};
  const auto oracle = Oracle::of(built->volume);
  const auto hits = hitsOf(built->volume, asking(format, kPoint), rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit exact = oracle->answer(rays[i], kPoint);
    EXPECT_EQ(std::memcmp(&hits[i], &exact, sizeof exact), 0) << i << ": " << textOf(hits[i]);
  }
}

INSTANTIATE_TEST_SUITE_P(On, Queries, ::testing::Values("cpu", "llvmpipe"), test::deviceName);

} // namespace
} // namespace voxc
