// Built volumes hold exactly the voxels of their source, in every format.
#include "SharedFolder.h"
#include "TestLength.h"

#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Source/Sources.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace voxc {
namespace {

using test::HardScene;
using test::hardScenes;

Format formatOf(std::string_view text, bool dedup = false) {
  auto format = parseFormat(text);
  EXPECT_TRUE(format) << format.error().message;
  Diagnostics diagnostics;
  if (dedup)
    findPass("whole-level-dedup")->run(*format, diagnostics);
  return *format;
}

Volume buildScene(const Constructor &constructor, const HardScene &scene) {
  const auto source = scene.source();
  auto built = constructor.build(*source);
  EXPECT_TRUE(built) << built.error().message;
  return std::move(built->volume);
}

/// Every voxel of the format by lookup, and all cubes of `decode`, against the scene.
::testing::AssertionResult holds(const Volume &volume, const HardScene &scene) {
  const Int3 extent = volume.format().extent();
  std::uint64_t voxels = 0;
  for (Int3 c; c.z < extent.z; ++c.z)
    for (c.y = 0; c.y < extent.y; ++c.y)
      for (c.x = 0; c.x < extent.x; ++c.x) {
        const std::uint32_t expected = contains(scene.extent, c) ? scene.voxel(c) : 0;
        voxels += expected != 0;
        if (volume.lookup(c).value != expected)
          return ::testing::AssertionFailure() << "lookup differs at " << c.x << "," << c.y << "," << c.z;
      }
  std::uint64_t decoded = 0;
  bool equal = true;
  const auto decoding = decode(volume, [&](const Cube &cube, std::uint32_t word) {
    decoded += std::uint64_t{1} << (3 * cube.log2Side);
    equal = equal && scene.voxel(cube.low) == word;
    return true;
  });
  if (!decoding)
    return ::testing::AssertionFailure() << decoding.error().message;
  if (!equal || decoded != voxels || volume.info().voxels != voxels)
    return ::testing::AssertionFailure() << "decoded " << decoded << " and counted " << volume.info().voxels
                                         << " of " << voxels << " voxels";
  const auto checked = checkStructure(volume.format(), volume.words());
  if (checked && *checked != voxels)
    return ::testing::AssertionFailure() << "the structure check counted " << *checked << " voxels";
  return checked ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << checked.error().message;
}

void expectLossless(const Format &format) {
  const auto constructor = Constructor::compile(format);
  ASSERT_TRUE(constructor) << constructor.error().message;
  for (const HardScene &scene : hardScenes(format.extent()))
    EXPECT_TRUE(holds(buildScene(*constructor, scene), scene)) << toString(format) << ", " << scene.name;
}

class EveryFormat : public ::testing::TestWithParam<const char *> {};

TEST_P(EveryFormat, IsLossless) {
  expectLossless(formatOf(GetParam()));
  expectLossless(formatOf(GetParam(), true));
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat,
                         ::testing::Values("R(4^3)", "D(4^3, 6)", "S(4)", "G(4)", "G(5)", "D(4^3, 1)",
                                           "D(2^3, 1000)", "D(3^3, 4294967295)", "R(0^3)", "D(0^3, 1)",
                                           "S(0)", "G(0)", "S(0) G(0)", "R(2,0,1)", "R(1,0,2) D(2,2,2,4)",
                                           "D(0,3,1,2) S(1)", "R(5,0,0) G(0) S(1)", "S(2) S(2)", "G(2) G(2)",
                                           "S(2) G(2)", "G(2) R(2^3)", "S(1) D(1^3,3) G(2)",
                                           "G(3) S(0) G(1)"));

TEST(Constructor, IsLosslessForRandomFormats) {
  std::mt19937 random(7);
  for (int i = 0; i < test::rounds(12); ++i)
    expectLossless(test::randomFormat(random, test::pick(random, 3, 5)));
}

TEST(Constructor, PadsWhatIsSmallerThanTheFormat) {
  const auto constructor = Constructor::compile(formatOf("S(2) G(3)"));
  ASSERT_TRUE(constructor);
  for (const HardScene &scene : hardScenes({20, 7, 31})) {
    const Volume volume = buildScene(*constructor, scene);
    EXPECT_EQ(volume.info().extent, scene.extent);
    EXPECT_TRUE(holds(volume, scene)) << scene.name;
  }
}

TEST(Constructor, RefusesWhatIsLarger) {
  const auto constructor = Constructor::compile(formatOf("R(2^3)"));
  const auto built = constructor->build(*makeFunctionSource({5, 1, 1}, [](Int3) { return 1u; }));
  ASSERT_FALSE(built);
  EXPECT_THAT(built.error().message, ::testing::HasSubstr("5 x 1 x 1"));
}

TEST(Constructor, WritesTheLayoutOfTheDocumentation) {
  const auto words = [](const char *format, std::uint32_t (*voxel)(Int3)) {
    const Format parsed = formatOf(format);
    const auto built = Constructor::compile(parsed)->build(*makeFunctionSource(parsed.extent(), voxel));
    const auto span = built->volume.words();
    return std::vector<std::uint32_t>(span.begin(), span.end());
  };
  const auto first = [](Int3 c) { return c == Int3{1, 0, 0} ? 9u : 0u; };
  const auto full = [](Int3) { return 7u; };
  using Words = std::vector<std::uint32_t>;
  EXPECT_EQ(words("R(1^3)", [](Int3) { return 0u; }), (Words{0}));
  EXPECT_EQ(words("R(1,1,0)", first), (Words{1, 0, 9, 0, 0}));
  EXPECT_EQ(words("D(2,0,0,2)", first), (Words{1, 0, 1, 9, 0, 0, 1, 0, 2}));
  EXPECT_EQ(words("S(1)", first), (Words{3, 9, 0, 1, 0x0202}));
  EXPECT_EQ(words("G(1)", first), (Words{2, 9, 0x0202, 1}));
  // A homogeneous sub-volume keeps an inner root of eight equal leaves; below it, equal leaves collapse.
  EXPECT_EQ(words("G(3)", full), (Words{2, 7, 0xffff, 1, 1, 1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(words("S(2)", full), (Words{17, 7, 0, 7, 0, 7, 0, 7, 0, 7, 0, 7, 0, 7, 0, 7, 0, 1, 0xffff}));
  EXPECT_EQ(words("S(0)", full), (Words{1, 7, 0}));
  EXPECT_EQ(words("G(0)", full), (Words{1, 7}));
}

TEST(Constructor, NeverCollapsesEqualInnerNodes) {
  // Eight equal inner nodes are one node with eight pointers to it, not a level less.
  const Format format = formatOf("G(5)");
  const auto built = Constructor::compile(format)->build(
      *makeFunctionSource({32, 32, 32}, [](Int3 c) { return (c.x ^ c.y ^ c.z) & 1 ? 5u : 0u; }));
  // One leaf, one node over the cells (of 4 children), and four nodes above with eight children each.
  EXPECT_EQ(built->volume.words().size(), 1u + 1 + 5 + 4 * 9);
}

TEST(Constructor, SharesNodesAcrossParentsIfTheLevelDoes) {
  const auto size = [](bool dedup) {
    const Format format = formatOf("R(1^3) S(1) G(2)", dedup);
    const auto built = Constructor::compile(format)->build(
        *makeFunctionSource({16, 16, 16}, [](Int3 c) { return (c.x & c.y & c.z) % 4 == 1 ? 5u : 0u; }));
    return built->volume.words().size();
  };
  EXPECT_LT(size(true), size(false));
}

TEST(Constructor, StopsWhenAsked) {
  const auto constructor = Constructor::compile(formatOf("R(3^3) G(4)"));
  const std::atomic<bool> stop = true;
  BuildOptions options;
  options.progress.stop = &stop;
  const auto built =
      constructor->build(*makeFunctionSource({128, 128, 128}, [](Int3) { return 1u; }), options);
  ASSERT_FALSE(built);
  EXPECT_EQ(built.error().kind, ErrorKind::Interrupted);
}

TEST(Constructor, BuildsThePapersFormats) {
  std::ifstream file(test::sharedFolder() + "/formats/paper-512.txt");
  if (!file)
    GTEST_SKIP() << "the paper's format list is not beside the checkout";
  std::string line;
  int formats = 0;
  while (std::getline(file, line)) {
    const Format format = formatOf(line.substr(line.find('\t') + 1), true);
    const auto constructor = Constructor::compile(format);
    ASSERT_TRUE(constructor) << constructor.error().message;
    const auto built = constructor->build(**makeBuiltinSource("shell", 64));
    ASSERT_TRUE(built) << built.error().message;
    EXPECT_TRUE(checkStructure(format, built->volume.words())) << toString(format);
    ++formats;
  }
  EXPECT_EQ(formats, 20);
}

} // namespace
} // namespace voxc
