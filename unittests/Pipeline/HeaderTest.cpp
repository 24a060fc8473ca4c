// The functions of headers, as C++ and as GLSL: what they find of a ray between two moments, to the bit.
#include "BuiltScene.h"
#include "HeaderDefinition.h"
#include "HeaderQueries.h"
#include "TestLength.h"

#include "Emit/RuntimeText.h"
#include "Jit/Jit.h"
#include "Oracle/BruteForce.h"
#include "testing/HardRays.h"
#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Emit/Emit.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Trace/Tracer.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace voxc {
namespace {

constexpr const char *kKindsOfSlots[] = {
    "R(4^3)",
    "D(4^3, 6)",
    "S(4)",
    "G(4, 2)",
    "M(2^3) M(2^3)",
    "H(2^3) H(2^3)",
    "S(0)",
    "R(1,2,0) G(2)",
    "format { level 1: svdag(4) traversal=restart }",
    "format { level 1: svo(3) traversal=unrolled level 2: raw(1, 1, 1) }",
    "format levels=flat { level 1: svdag(2) level 2: distance(2, 2, 2, 5) }",
    ("format levels=direct { level 1: distance(2, 2, 2, 15) distances=in-slot metric=octant level 2: "
     "masked(2, 2, 2) }"),
    "format granule=4 { level 1: raw(2, 2, 2) level 2: svdag(2) }",
    "format query=any payload=occupancy { level 1: svdag(2) level 2: masked(2, 2, 2) }",
    "format payload=palette(16) values=apart { level 1: raw(1, 1, 1) level 2: svdag(3) }",
    "format values=apart { level 1: svdag(1) level 2: masked(3, 3, 3) }"};

/// With most of what a header may have: steps by distances, masks, ranks, numbers, reflections and granules.
constexpr const char *kFewFormats[] = {
    ("format levels=direct { level 1: distance(2, 2, 2, 15) distances=in-slot metric=octant level 2: "
     "masked(2, 2, 2) }"),
    "format values=apart { level 1: svdag(1) level 2: masked(3, 3, 3) }",
    "format granule=4 { level 1: raw(2, 2, 2) level 2: svdag(2) }"};

std::string headerOf(const Format &format, HeaderLanguage language) {
  const auto plan = makePlan(format, kHeaderPlan);
  EXPECT_TRUE(plan) << plan.error().message;
  return emitHeader(*plan, "test", language);
}

/// A header's functions in this process.
class Functions {
public:
  explicit Functions(const Format &format, HeaderLanguage language = HeaderLanguage::Shared)
      : code_(compiled(format, language)) {
    all_ = reinterpret_cast<All>(*code_.find("all"));
    any_ = reinterpret_cast<Any>(*code_.find("any"));
    outside_ = reinterpret_cast<Outside>(*code_.find("outside"));
  }

  std::vector<HeaderHit> hits(const Volume &volume, const HeaderQuery &query) const {
    std::vector<HeaderHit> hits(64);
    hits.resize(all_(volume.words().data(), &query, hits.data()));
    return hits;
  }
  /// The cell of the point from which rays go on.
  Int3 cellOutside(const HeaderQuery &query, const HeaderHit &hit) const {
    float point[3];
    outside_(&query, &hit, point);
    return {static_cast<int>(std::floor(point[0])), static_cast<int>(std::floor(point[1])),
            static_cast<int>(std::floor(point[2]))};
  }
  bool any(const Volume &volume, const HeaderQuery &query) const {
    return any_(volume.words().data(), &query);
  }

private:
  using All = unsigned (*)(const std::uint32_t *, const HeaderQuery *, HeaderHit *);
  using Any = bool (*)(const std::uint32_t *, const HeaderQuery *);
  using Outside = void (*)(const HeaderQuery *, const HeaderHit *, float *);

  static JitCode compiled(const Format &format, HeaderLanguage language) {
    const std::string header = headerOf(format, language);
    constexpr const char *kText = R"(
#include "header.h"
struct HeaderQuery { float o[3], d[3], tmin, tmax; };
extern "C" unsigned all(const unsigned *words, const HeaderQuery *q, voxc_test_Hit *hits) {
  unsigned count = 0;
  voxc_test_Hit hit;
  bool found = voxc_test_closest(words, {q->o[0], q->o[1], q->o[2]}, {q->d[0], q->d[1], q->d[2]}, q->tmin, q->tmax, hit);
  for (; found && count < 64; found = voxc_test_next(words, {q->o[0], q->o[1], q->o[2]}, {q->d[0], q->d[1], q->d[2]}, q->tmax, hit))
    hits[count++] = hit;
  return count;
}
extern "C" void outside(const HeaderQuery *q, const voxc_test_Hit *hit, float *p) {
  const auto point = voxc_test_outside({q->o[0], q->o[1], q->o[2]}, {q->d[0], q->d[1], q->d[2]}, *hit);
  p[0] = point.x;
  p[1] = point.y;
  p[2] = point.z;
}
extern "C" bool any(const unsigned *words, const HeaderQuery *q) {
  return voxc_test_any(words, {q->o[0], q->o[1], q->o[2]}, {q->d[0], q->d[1], q->d[2]}, q->tmin, q->tmax);
}
)";
    auto code = JitCode::compile({{"test.cpp", kText}, {"header.h", header}},
                                 {.optimisation = 2, .processor = "native"});
    EXPECT_TRUE(code) << code.error().message;
    return std::move(*code);
  }

  JitCode code_;
  All all_;
  Any any_;
  Outside outside_;
};

std::vector<Ray> raysThrough(Int3 extent, const Oracle &oracle, int count, std::uint32_t seed) {
  const std::vector<Int3> voxels = oracle.sampleVoxels(16);
  const auto classes = test::hardRayClasses();
  std::vector<Ray> rays = verifyRays(extent, count, seed);
  for (const test::HardRayClass &kind : classes) {
    const auto hard = test::hardRays({extent, voxels}, kind.name, 1 + count / classes.size(), seed);
    rays.insert(rays.end(), hard.begin(), hard.end());
  }
  return rays;
}

/// The cell on the other side of the face by which a voxel is entered.
Int3 cellBefore(const HeaderHit &hit) {
  Int3 cell{hit.voxel[0], hit.voxel[1], hit.voxel[2]};
  cell[hit.axis] += hit.side;
  return cell;
}

void expectDefinedHits(const Format &format, std::uint32_t seed,
                       HeaderLanguage language = HeaderLanguage::Shared) {
  SCOPED_TRACE(std::string(toString(language)) + ", " + printIr(format));
  std::mt19937 random(seed);
  const Functions functions(format, language);
  const auto scenes = test::hardScenes(format.extent());
  const test::HardScene &scene = scenes[random() % scenes.size()];
  const Volume volume = test::builtScene(format, scene);
  const Oracle oracle = *Oracle::of(volume);
  for (const Ray &ray : raysThrough(format.extent(), oracle, test::rounds(60), seed)) {
    if (testing::Test::HasFailure())
      return; // One is enough to look at.
    const std::vector<Entry> entries = entriesOf(oracle, format.extent(), ray);
    const HeaderQuery query = randomQuery(random, ray, entries);
    const std::vector<HeaderHit> expected = expectedHits(entries, query);
    EXPECT_EQ(functions.hits(volume, query), expected)
        << scene.name << std::hexfloat << " o " << ray.origin[0] << ' ' << ray.origin[1] << ' '
        << ray.origin[2] << " d " << ray.direction[0] << ' ' << ray.direction[1] << ' ' << ray.direction[2]
        << " t " << query.tmin << ' ' << query.tmax;
    EXPECT_EQ(functions.any(volume, query), !expected.empty());
    for (const HeaderHit &hit : expected) {
      if (hit.axis >= 0 && std::isfinite(hit.t)) {
        EXPECT_EQ(functions.cellOutside(query, hit), cellBefore(hit));
      }
    }
  }
}

TEST(Header, FindsWhatIsDefinedInEveryKindOfLevel) {
  std::uint32_t seed = 1;
  for (const char *text : kKindsOfSlots)
    expectDefinedHits(*parseFormat(text), seed++);
}

/// Of CUDA this is what its host compiles.
TEST(Header, FindsWhatIsDefinedInEveryLanguageOfAProcessor) {
  std::uint32_t seed = 50;
  for (const HeaderLanguage language : {HeaderLanguage::Cpp, HeaderLanguage::Cuda})
    for (const char *text : kFewFormats)
      expectDefinedHits(*parseFormat(text), seed++, language);
}

TEST(Header, FindsWhatIsDefinedInRandomFormats) {
  for (int i = 0; i < test::rounds(6); ++i) {
    std::mt19937 random(100 + i);
    expectDefinedHits(test::randomFormat(random, 4), 100 + i);
  }
}

/// A kernel as tracers take it, around a header: of two records of rays it makes a query, and of that the
/// first hit, and beside it whether there is any, how many there are, and a number made of all of them.
Kernel queryKernel(const Format &format, HeaderLanguage language) {
  Plan plan = *makePlan(format, kHeaderPlan);
  plan.bounded = false;    // Its rays are records of six numbers, whatever the header takes.
  plan.loops = Loops::Cut; // The scenes are so small that no device cuts anything.
  const std::string interface = "#version 460\n" + std::string(runtimeFile(shaderFiles(), "interface.glsl"));
  const bool isHlsl = language == HeaderLanguage::Hlsl;
  const std::string header = headerOf(format, language);
  auto kernel = compileGlsl(isHlsl ? interface + "void main() {}\n"
                                   : interface + kQueriesInGlsl[0] + header + kQueriesInGlsl[1],
                            plan);
  EXPECT_TRUE(kernel) << kernel.error().message;
  if (isHlsl)
    kernel->spirv = test::compileHlsl(kQueriesInHlsl[0] + header + kQueriesInHlsl[1]);
  return std::move(*kernel);
}

/// What that kernel answers, by the same text in C++.
std::vector<Hit> answers(const std::vector<HeaderHit> &hits) {
  const HeaderHit first = hits.empty() ? HeaderHit{} : hits[0];
  const auto mixed = [](std::uint32_t a, std::uint32_t b) { return (a ^ b) * 0x01000193u; };
  std::uint32_t all = 0;
  for (const HeaderHit &hit : hits)
    all = mixed(mixed(all, hit.voxel[0] + 16 * hit.voxel[1] + 256 * hit.voxel[2]),
                std::bit_cast<std::uint32_t>(hit.t));
  Hit record{{}, first.colour, first.t, static_cast<std::uint32_t>(4 * first.axis + first.side)};
  std::copy_n(first.voxel, 3, record.voxel);
  return {
      record,
      {{!hits.empty(), static_cast<std::int32_t>(hits.size()), static_cast<std::int32_t>(all & 0x7fffffff)},
       0,
       0,
       0}};
}

void expectTheHitsOfCpp(Device &device, const Format &format, HeaderLanguage language, std::uint32_t seed) {
  SCOPED_TRACE(std::string(toString(language)) + ", " + printIr(format));
  std::mt19937 random(seed);
  const Volume volume = test::builtScene(format, test::hardScenes(format.extent())[7]);
  const Oracle oracle = *Oracle::of(volume);
  const Functions functions(format);
  std::vector<HeaderQuery> queries;
  std::vector<Hit> expected;
  for (const Ray &ray : raysThrough(format.extent(), oracle, 1000, seed)) {
    const auto all = functions.hits(volume, {ray, 0, std::numeric_limits<float>::infinity()});
    std::vector<Entry> entries;
    for (const HeaderHit &hit : all)
      entries.push_back({{}, hit});
    queries.push_back(randomQuery(random, ray, entries));
    const std::vector<Hit> answer = answers(functions.hits(volume, queries.back()));
    expected.insert(expected.end(), answer.begin(), answer.end());
  }
  std::vector<Hit> hits(expected.size());
  auto tracer = createTracer(device, queryKernel(format, language), volume);
  ASSERT_TRUE(tracer) << tracer.error().message;
  const std::span<const Ray> records(reinterpret_cast<const Ray *>(queries.data()), hits.size());
  const auto report = (*tracer)->trace(records, hits, {.order = RayOrder::Given});
  ASSERT_TRUE(report) << report.error().message;
  int wrong = 0;
  for (std::size_t i = 0; i < queries.size(); ++i)
    wrong += std::memcmp(&hits[2 * i], &expected[2 * i], sizeof(Hit)) != 0 ||
             std::memcmp(&hits[2 * i + 1], &expected[2 * i + 1], 12) != 0;
  EXPECT_EQ(wrong, 0) << "of " << queries.size();
}

TEST(Header, FindsTheSameOnADevice) {
  auto device = Device::open("llvmpipe");
  if (!device)
    GTEST_SKIP() << device.error().message;
  std::uint32_t seed = 30;
  for (const HeaderLanguage language : {HeaderLanguage::Shared, HeaderLanguage::Glsl, HeaderLanguage::Hlsl})
    for (const char *text : kFewFormats)
      expectTheHitsOfCpp(*device, *parseFormat(text), language, seed++);
}

} // namespace
} // namespace voxc
