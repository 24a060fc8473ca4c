// References that count granules: the same voxels and hits as without, wherever in a volume nodes lie, past
// 2^32 words too.
#include "TestLength.h"

#include "testing/HardRays.h"
#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Construct/Split.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Trace/Tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>

#include <sys/stat.h>

namespace voxc {
namespace {

/// Every kind of level, slots and skips, apart and below each other.
constexpr const char *kFormats[] = {
    "format { level 1: raw(4, 4, 4) }",
    "format { level 1: raw(2, 3, 1) level 2: raw(1, 1, 1) }",
    "format { level 1: raw(0, 1, 0) level 2: svdag(3) }",
    "format { level 1: distance(2, 2, 2, 6) level 2: distance(2, 2, 2, 5) }",
    "format { level 1: distance(2, 2, 2, 15) distances=in-slot metric=octant level 2: masked(2, 2, 2) }",
    "format { level 1: svo(4) }",
    "format { level 1: svo(0) level 2: svo(2) level 3: raw(1, 1, 1) }",
    "format { level 1: svdag(4) }",
    "format { level 1: svdag(0) level 2: svdag(4, 2) dedup=level leaves=in-slot }",
    "format { level 1: svdag(2) level 2: hash(2, 2, 2) share=level }",
    "format { level 1: masked(1, 2, 1) level 2: masked(2, 2, 2) share=level }",
    "format { level 1: masked(3, 3, 3) level 2: hash(1, 1, 1) }",
    "format payload=occupancy { level 1: hash(1, 1, 1) level 2: svdag(3) }",
    "format payload=occupancy { level 1: raw(1, 1, 1) level 2: masked(1, 1, 1) level 3: masked(2, 2, 2) }",
    "format values=apart { level 1: distance(1, 1, 1, 4) level 2: svdag(3) dedup=level }",
    "format values=apart { level 1: raw(1, 1, 1) level 2: masked(1, 1, 1) share=level level 3: masked(2, 2, "
    "2) }",
    "format values=apart { level 1: svdag(2) level 2: masked(2, 2, 2) share=level }",
};

Format withGranule(Format format, std::string_view words) {
  format.setAttribute(kGranuleAttribute, words);
  return format;
}

bool isValid(const Format &format) {
  Diagnostics diagnostics;
  verify(format, diagnostics);
  return !diagnostics.hasErrors();
}

std::vector<Format> formatsWith(std::string_view words) {
  std::vector<Format> formats;
  for (const char *text : kFormats)
    if (const Format format = withGranule(*parseFormat(text), words); isValid(format))
      formats.push_back(format);
  return formats;
}

/// Any that can count granules, of a size that fits.
Format randomGranules(std::mt19937 &random) {
  while (true) {
    const Format format = test::randomFormat(random, test::pick(random, 3, 5));
    const auto &values = kGranuleAttribute.values;
    const auto words = values[static_cast<std::size_t>(test::pick(random, 1, 5))];
    if (const Format wider = withGranule(format, words); isValid(wider))
      return wider;
    if (const Format wide = withGranule(format, "2"); isValid(wide))
      return wide;
  }
}

/// Nothing of it is taken but what is written to.
std::shared_ptr<WorkingMemory> vastMemory() { return WorkingMemory::create(std::uint64_t{1} << 42); }

Expected<Volume> build(const Format &format, const test::HardScene &scene, std::uint64_t emptyWords = 0) {
  const auto constructor = Constructor::compile(format);
  if (!constructor)
    return constructor.error();
  auto built = constructor->build(*scene.source(), {.memory = vastMemory(), .emptyWords = emptyWords});
  if (!built)
    return built.error();
  return std::move(built->volume);
}

test::HardScene sceneOf(const Format &format, std::size_t number) {
  const auto scenes = test::hardScenes(format.extent());
  return scenes[number % scenes.size()];
}

void expectVoxels(const Volume &volume, const test::HardScene &scene) {
  const std::string what = printIr(volume.format()) + scene.name;
  const auto checked = checkStructure(volume.format(), volume.words());
  ASSERT_TRUE(checked) << what << ": " << checked.error().message;
  EXPECT_EQ(*checked, volume.info().voxels) << what;
  const auto source = scene.source();
  const bool hasColours = volume.layout().payload == Payload::Rgba8;
  for (std::int32_t z = 0; z < scene.extent.z; ++z)
    for (std::int32_t y = 0; y < scene.extent.y; ++y)
      for (std::int32_t x = 0; x < scene.extent.x; ++x) {
        const std::uint32_t voxel = scene.voxel({x, y, z});
        const std::uint32_t word = hasColours || voxel == 0 ? voxel : kOccupied;
        ASSERT_EQ(volume.lookup({x, y, z}).value, word) << what;
      }
  std::uint64_t voxels = 0;
  ASSERT_TRUE(decode(volume, [&](const Cube &cube, std::uint32_t) {
    voxels += std::uint64_t{1} << 3 * cube.log2Side;
    return true;
  }));
  EXPECT_EQ(voxels, volume.info().voxels) << what;
}

void expectExact(Expected<std::unique_ptr<Tracer>> tracer, const Volume &volume,
                 const test::HardScene &scene) {
  const std::string what = printIr(volume.format()) + scene.name;
  ASSERT_TRUE(tracer) << what << tracer.error().message;
  const auto rays = test::verifyRays(scene.extent, 2000, 5);
  std::vector<Hit> hits(rays.size());
  const auto report = (*tracer)->trace(rays, hits);
  ASSERT_TRUE(report) << what << report.error().message;
  EXPECT_TRUE(compare(*Oracle::of(volume), rays, hits).clean()) << what;
}

/// The walks that there are take turns: compiling takes most of the time.
Format walkedInTurn(Format format) {
  static constexpr std::string_view kWalks[] = {"", "restart-sv", "flat-walk", "unroll-sv", "direct-walk"};
  static std::size_t turn = 0;
  Diagnostics diagnostics; // A walk that does not apply leaves the format as it is.
  if (const Pass *pass = findPass(kWalks[turn++ % std::size(kWalks)]))
    pass->run(format, diagnostics);
  return format;
}

void expectExactOnCpu(const Volume &volume, const test::HardScene &scene) {
  const auto kernel = compileCpuKernel(walkedInTurn(volume.format()));
  ASSERT_TRUE(kernel) << kernel.error().message;
  expectExact(createCpuTracer(*kernel, volume, 2), volume, scene);
}

/// Nothing without llvmpipe.
void expectExactOnVulkan(const Volume &volume, const test::HardScene &scene, Addressing addressing) {
  auto device = Device::open("llvmpipe");
  if (!device)
    return;
  const auto kernel = compileKernel(walkedInTurn(volume.format()), {addressing});
  ASSERT_TRUE(kernel) << kernel.error().message;
  expectExact(createTracer(*device, *kernel, volume), volume, scene);
}

TEST(Granules, HoldTheVoxelsOfEveryKindOfLevel) {
  for (const char *words : {"2", "4", "256"})
    for (const Format &format : formatsWith(words)) {
      const test::HardScene scene = sceneOf(format, 5);
      const auto volume = build(format, scene);
      ASSERT_TRUE(volume) << volume.error().message;
      expectVoxels(*volume, scene);
    }
}

TEST(Granules, OfNothingAreAWholeGranule) {
  for (const char *values : {"in-place", "apart"}) {
    Format format = withGranule(*parseFormat("R(1^3) G(2)"), "4");
    format.setAttribute(kValuesAttribute, values);
    const auto volume = build(format, {"nothing", [](Int3) { return 0u; }, {}, format.extent()});
    ASSERT_TRUE(volume) << volume.error().message;
    EXPECT_EQ(volume->words().size(), 4u);
    EXPECT_EQ(*checkStructure(format, volume->words()), 0u);
  }
}

TEST(Granules, AreTracedExactlyOnBothBackEnds) {
  // Each format on each of them, with granules of one size there and of the other here.
  for (const bool isSmall : {true, false})
    for (std::size_t i = 0; i < std::size(kFormats); ++i) {
      const Format format = withGranule(*parseFormat(kFormats[i]), isSmall ? "2" : "8");
      if (!isValid(format))
        continue;
      const test::HardScene scene = sceneOf(format, 5 + i % 3);
      const auto volume = build(format, scene);
      ASSERT_TRUE(volume) << volume.error().message;
      if ((i % 2 == 0) == isSmall)
        expectExactOnCpu(*volume, scene);
      else
        expectExactOnVulkan(*volume, scene, i % 4 < 2 ? Addressing::Buffer : Addressing::Segments);
    }
}

TEST(Granules, AreTracedExactlyInRandomFormats) {
  std::mt19937 random(29);
  for (int i = 0; i < test::rounds(5); ++i) {
    const Format format = randomGranules(random);
    const test::HardScene scene = sceneOf(format, random());
    const auto volume = build(format, scene);
    ASSERT_TRUE(volume) << volume.error().message;
    expectVoxels(*volume, scene);
    expectExactOnCpu(*volume, scene);
    expectExactOnVulkan(*volume, scene, random() % 2 != 0 ? Addressing::Buffer : Addressing::Segments);
  }
}

/// Nodes begin behind 2^32 words, and so behind 16 GiB, which stay empty and take no memory.
TEST(Granules, ReachPastTwoToThe32Words) {
  constexpr std::uint64_t kEmpty = (std::uint64_t{1} << 32) + 12345;
  std::size_t turn = 0;
  for (Format format : formatsWith("2")) {
    Diagnostics diagnostics; // References beside octants have fewer bits.
    while (layoutOf(format).maxWords() < 2 * kEmpty)
      ASSERT_EQ(granules(format, diagnostics), PassResult::Changed);
    const test::HardScene scene = sceneOf(format, 6);
    const auto volume = build(format, scene, kEmpty);
    ASSERT_TRUE(volume) << volume.error().message;
    ASSERT_GT(volume->words().size(), kEmpty);
    expectVoxels(*volume, scene);
    if (turn++ % 3 == 0)
      expectExactOnCpu(*volume, scene);
  }
}

TEST(Granules, ReachPastTwoToThe32WordsInRandomFormats) {
  std::mt19937 random(31);
  for (int i = 0; i < test::rounds(4); ++i) {
    const Format format = randomGranules(random);
    const test::HardScene scene = sceneOf(format, random());
    const std::uint64_t most = std::uint64_t{1} << (32 + format.log2Granule());
    // An address of 2^36 words is as far as any test machine has room for.
    const std::uint64_t empty = std::min(most / 4 * 3, std::uint64_t{1} << 36) + random() % 1000;
    const auto volume = build(format, scene, empty);
    ASSERT_TRUE(volume) << volume.error().message;
    expectVoxels(*volume, scene);
    expectExactOnCpu(*volume, scene);
  }
}

TEST(Granules, ReachPastTwoToThe32WordsOnVulkan) {
  // What is empty is one segment of 1 GiB; the nodes lie across the border of two others, which goes through
  // a large one of them.
  constexpr std::uint64_t kBorder = (std::uint64_t{1} << 32) + kSegmentWords;
  for (const char *text : {"R(1^3) R(3^3)", "D(1^3, 3) G(3)"}) {
    const Format format = withGranule(*parseFormat(text), "2");
    const test::HardScene scene = sceneOf(format, 5);
    const auto near = build(format, scene);
    ASSERT_TRUE(near) << near.error().message;
    const auto volume = build(format, scene, kBorder - near->words().size() / 2);
    ASSERT_TRUE(volume) << volume.error().message;
    expectExactOnVulkan(*volume, scene, Addressing::Segments);
  }
}

/// Words today, with a reference in each half of those that gathers reach, which have signed offsets.
TEST(Granules, AreNotNeededBelowTwoToThe32Words) {
  const Format format = *parseFormat("R(1^3) G(3)");
  const test::HardScene scene = sceneOf(format, 6);
  for (const std::uint64_t empty : {(std::uint64_t{1} << 31) - 50, (std::uint64_t{1} << 32) - 40000}) {
    const auto volume = build(format, scene, empty);
    ASSERT_TRUE(volume) << volume.error().message;
    expectVoxels(*volume, scene);
    expectExactOnCpu(*volume, scene);
  }
}

TEST(Granules, AreWhatABuildOfTooManyWordsAsksFor) {
  const test::HardScene scene = sceneOf(*parseFormat("G(4)"), 6);
  const auto messageOf = [&](const Format &format) {
    const std::uint64_t most = layoutOf(format).maxWords();
    const auto volume = build(format, scene, most - 20);
    return volume ? "" : volume.error().message;
  };
  EXPECT_NE(messageOf(*parseFormat("G(4)")).find("2^32 words (16 GiB), the most that references can reach"),
            std::string::npos);
  EXPECT_NE(messageOf(*parseFormat("G(4)")).find("granule=2 (the pass granules)"), std::string::npos);
  EXPECT_NE(messageOf(withGranule(*parseFormat("G(4)"), "2")).find("granule=4 (granules once more)"),
            std::string::npos);
  EXPECT_EQ(messageOf(withGranule(*parseFormat("S(4)"), "2")).find("granule="), std::string::npos);
}

class GranuleFiles : public ::testing::Test {
protected:
  GranuleFiles() : folder_(std::filesystem::path(::testing::TempDir()) / "voxc-granules") {
    std::filesystem::create_directories(folder_);
  }
  ~GranuleFiles() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string &name) const { return (folder_ / name).string(); }

  static void expectSameWords(const Volume &volume, const Expected<Volume> &other) {
    ASSERT_TRUE(other) << other.error().message;
    const std::string what = printIr(volume.format());
    ASSERT_TRUE(std::ranges::equal(volume.words(), other->words())) << what;
  }

  std::filesystem::path folder_;
};

TEST_F(GranuleFiles, AreTheSameInPartsAndCompressed) {
  for (const char *words : {"2", "16"})
    for (const Format &format : formatsWith(words)) {
      const test::HardScene scene = sceneOf(format, 6);
      const auto constructor = Constructor::compile(format);
      ASSERT_TRUE(constructor) << constructor.error().message;
      const auto built = constructor->build(*scene.source());
      ASSERT_TRUE(built) << built.error().message;
      const Volume &volume = built->volume;
      std::vector<std::string> apart;
      std::vector<std::string> split;
      for (const std::uint64_t i : {0u, 1u}) {
        apart.push_back(path("built" + std::to_string(i)));
        split.push_back(path("split" + std::to_string(i)));
        ASSERT_TRUE(constructor->buildFragment(*scene.source(), i, 2, apart.back()));
        ASSERT_TRUE(splitVolume(volume, i, 2, split.back()));
      }
      for (const auto &paths : {apart, split}) {
        auto merged = constructor->merge(paths);
        ASSERT_TRUE(merged) << merged.error().message;
        expectSameWords(volume, std::move(merged->volume));
      }
      ASSERT_TRUE(volume.save(path("small.hvx"), {.compress = true}));
      expectSameWords(volume, Volume::load(path("small.hvx")));
    }
}

TEST_F(GranuleFiles, OfFarNodesFallIntoTheSameParts) {
  for (const Format &format : formatsWith("2")) {
    const std::uint64_t empty = layoutOf(format).maxWords() / 4 * 3;
    const test::HardScene scene = sceneOf(format, 5);
    const auto near = build(format, scene);
    const auto far = build(format, scene, empty);
    ASSERT_TRUE(near && far);
    ASSERT_TRUE(splitVolume(*far, 0, 1, path("far.hvf")));
    auto merged = Constructor::compile(format)->merge({path("far.hvf")});
    ASSERT_TRUE(merged) << merged.error().message;
    expectSameWords(*near, std::move(merged->volume));
  }
}

TEST_F(GranuleFiles, HaveHolesWhereTheirWordsAreEmpty) {
  const Format format = withGranule(*parseFormat("R(2^3) G(3)"), "2");
  const test::HardScene scene = sceneOf(format, 6);
  const auto constructor = Constructor::compile(format);
  ASSERT_TRUE(constructor) << constructor.error().message;
  constexpr std::uint64_t kEmpty = std::uint64_t{1} << 28;
  const auto built = constructor->build(
      *scene.source(), {.memory = vastMemory(), .path = path("far.hvx"), .emptyWords = kEmpty});
  ASSERT_TRUE(built) << built.error().message;
  const auto loaded = Volume::load(path("far.hvx"));
  expectSameWords(built->volume, loaded);
  EXPECT_GT(std::filesystem::file_size(path("far.hvx")), 4 * kEmpty);
  struct stat status{};
  ASSERT_EQ(::stat(path("far.hvx").c_str(), &status), 0);
  EXPECT_LT(status.st_blocks * 512, std::int64_t{1} << 20) << "bytes that the file takes";
}

} // namespace
} // namespace voxc
