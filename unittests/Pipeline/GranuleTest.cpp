// References that count granules: the same voxels and hits as without, wherever in a volume nodes lie, past
// 2^32 words too.
#include "GranuleTesting.h"
#include "NewFolder.h"
#include "TestLength.h"

#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Oracle/VerifyRays.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Trace/Tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>
#include <string>

namespace voxc {
namespace {

using namespace test;

/// Any that can count granules, of a size that fits.
Format randomGranules(std::mt19937 &random) {
  while (true) {
    const Format format = randomFormat(random, pick(random, 3, 5));
    const auto &values = kGranuleAttribute.values;
    const auto words = values[static_cast<std::size_t>(pick(random, 1, 5))];
    if (const Format wider = withGranule(format, words); isValid(wider))
      return wider;
    if (const Format wide = withGranule(format, "2"); isValid(wide))
      return wide;
  }
}

/// One whose references reach past 2^32 words; those beside octants have fewer bits.
Format randomFarGranules(std::mt19937 &random) {
  while (true) {
    Format format = randomGranules(random);
    Diagnostics diagnostics;
    do {
      if (layoutOf(format).maxWords() > std::uint64_t{1} << 32)
        return format;
    } while (granules(format, diagnostics) == PassResult::Changed);
  }
}

void expectVoxels(const Volume &volume, const HardScene &scene) {
  const std::string what = printIr(volume.format()) + scene.name;
  const auto checked = checkStructure(volume.format(), volume.words());
  ASSERT_TRUE(checked) << what << ": " << checked.error().message;
  EXPECT_EQ(*checked, volume.info().voxels) << what;
  const Payload payload = volume.layout().payload;
  const bool hasColours = payload != Payload::Occupancy && payload != Payload::Constant;
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

void expectExact(Expected<std::unique_ptr<Tracer>> tracer, const Volume &volume, const HardScene &scene) {
  const std::string what = printIr(volume.format()) + scene.name;
  ASSERT_TRUE(tracer) << what << tracer.error().message;
  const auto rays = verifyRays(scene.extent, 2000, 5);
  std::vector<Hit> hits(rays.size());
  const auto report = (*tracer)->trace(rays, hits);
  ASSERT_TRUE(report) << what << report.error().message;
  EXPECT_TRUE(compare(*Oracle::of(volume), rays, hits).clean()) << what;
}

/// The traversals that there are take turns: compiling takes most of the time.
Format traversedInTurn(Format format) {
  static constexpr std::string_view kTraversals[] = {"", "restart-sv", "flat-traversal", "unroll-sv",
                                                     "direct-traversal"};
  static std::size_t turn = 0;
  Diagnostics diagnostics; // A traversal that does not apply leaves the format as it is.
  if (const Pass *pass = findPass(kTraversals[turn++ % std::size(kTraversals)]))
    pass->run(format, diagnostics);
  return format;
}

void expectExactOnCpu(const Volume &volume, const HardScene &scene) {
  const auto kernel = compileCpuKernel(traversedInTurn(volume.format()), {.start = CpuStart::Fast});
  ASSERT_TRUE(kernel) << kernel.error().message;
  expectExact(createCpuTracer(*kernel, volume, 2), volume, scene);
}

/// Nothing without llvmpipe.
void expectExactOnVulkan(const Volume &volume, const HardScene &scene, Addressing addressing) {
  auto device = Device::open("llvmpipe");
  if (!device)
    return;
  const auto kernel = compileKernel(traversedInTurn(volume.format()), {addressing});
  ASSERT_TRUE(kernel) << kernel.error().message;
  expectExact(createTracer(*device, *kernel, volume), volume, scene);
}

TEST(Granules, HoldTheVoxelsOfEveryKindOfLevel) {
  for (const char *words : {"2", "4", "256"})
    for (const Format &format : formatsWith(words)) {
      const HardScene scene = sceneOf(format, 5);
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
      const HardScene scene = sceneOf(format, 5 + i % 3);
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
  for (int i = 0; i < rounds(5); ++i) {
    const Format format = randomGranules(random);
    const HardScene scene = sceneOf(format, random());
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
    while (layoutOf(format).maxWords() < kEmpty + kEmpty / 2)
      ASSERT_EQ(granules(format, diagnostics), PassResult::Changed);
    const HardScene scene = sceneOf(format, 6);
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
  int reached = 0;
  for (int i = 0; i < rounds(4); ++i) {
    const Format format = randomFarGranules(random);
    const HardScene scene = sceneOf(format, random());
    const std::uint64_t most = layoutOf(format).maxWords();
    // An address of 2^36 words is as far as any test machine has room for.
    const std::uint64_t empty = std::min(most / 4 * 3, std::uint64_t{1} << 36) + random() % 1000;
    const auto volume = build(format, scene, empty);
    ASSERT_TRUE(volume) << volume.error().message;
    if (volume->info().voxels == 0)
      continue; // No node stands behind the empty words.
    ASSERT_GT(volume->words().size(), std::uint64_t{1} << 32);
    expectVoxels(*volume, scene);
    expectExactOnCpu(*volume, scene);
    ++reached;
  }
  EXPECT_GT(reached, rounds(4) / 2) << "most scenes were without a voxel";
}

TEST(Granules, ReachPastTwoToThe32WordsOnVulkan) {
  // What is empty is one segment of 1 GiB; the nodes lie across the border of two others, which goes through
  // a large one of them. To find that out, the tracer reads all of it: of a file, whose pages can be dropped
  // again, while some kernels keep a page of memory for each that was read.
  constexpr std::uint64_t kBorder = (std::uint64_t{1} << 32) + kSegmentWords;
  const auto folder = newFolder("voxc-granules");
  for (const char *text : {"R(1^3) R(3^3)", "D(1^3, 3) G(3)"}) {
    const Format format = withGranule(*parseFormat(text), "2");
    const HardScene scene = sceneOf(format, 5);
    const auto near = build(format, scene);
    ASSERT_TRUE(near) << near.error().message;
    const auto path = (folder / "far.hvx").string();
    const auto volume = build(format, scene, kBorder - near->words().size() / 2, path);
    ASSERT_TRUE(volume) << volume.error().message;
    expectExactOnVulkan(*volume, scene, Addressing::Segments);
  }
  std::filesystem::remove_all(folder);
}

/// Words today, with a reference in each half of those that gathers reach, which have signed offsets.
TEST(Granules, AreNotNeededBelowTwoToThe32Words) {
  const Format format = *parseFormat("R(1^3) G(3)");
  const HardScene scene = sceneOf(format, 6);
  for (const std::uint64_t empty : {(std::uint64_t{1} << 31) - 50, (std::uint64_t{1} << 32) - 40000}) {
    const auto volume = build(format, scene, empty);
    ASSERT_TRUE(volume) << volume.error().message;
    expectVoxels(*volume, scene);
    expectExactOnCpu(*volume, scene);
  }
}

TEST(Granules, AreWhatABuildOfTooManyWordsAsksFor) {
  const HardScene scene = sceneOf(*parseFormat("G(4)"), 6);
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

} // namespace
} // namespace voxc
