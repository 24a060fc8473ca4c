// However a volume is cut into parts, its bytes are the same.
#include "TestLength.h"

#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Source/Sources.h"
#include "voxc/Support/File.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <random>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace voxc {
namespace {

using Words = std::vector<std::uint32_t>;

Words wordsOf(const Expected<Built> &built) {
  if (!built)
    return ADD_FAILURE() << built.error().message, Words();
  const auto words = built->volume.words();
  return {words.begin(), words.end()};
}

/// A source of a function that makes its voxels in cubes of another size, and that has views.
class ChunkedSource final : public VoxelSource {
public:
  ChunkedSource(test::HardScene scene, int log2Chunk) : scene_(std::move(scene)), log2Chunk_(log2Chunk) {}

  Int3 extent() const override { return scene_.extent; }
  int log2Chunk() const override { return log2Chunk_; }
  std::unique_ptr<VoxelSource> view() const override {
    return std::make_unique<ChunkedSource>(scene_, log2Chunk_);
  }
  bool empty(const Cube &) override { return false; }
  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    for (std::uint64_t i = 0; i < std::uint64_t{1} << (3 * cube.log2Side); ++i) {
      const Int3 cell = cube.low + mortonCell(i);
      words[i] = contains(scene_.extent, cell) ? scene_.voxel(cell) : 0;
    }
    return {};
  }

private:
  test::HardScene scene_;
  int log2Chunk_;
};

class Parts : public ::testing::Test {
protected:
  Parts() : folder_(std::filesystem::path(::testing::TempDir()) / "voxc-parts") {
    std::filesystem::create_directories(folder_);
  }
  ~Parts() override { std::filesystem::remove_all(folder_); }

  std::string path(std::uint64_t i) const { return (folder_ / std::to_string(i)).string(); }

  Words merged(const Constructor &constructor, VoxelSource &source, std::uint64_t fragments) const {
    std::vector<std::string> paths;
    for (std::uint64_t i = 0; i < fragments; ++i) {
      const auto report = constructor.buildFragment(source, i, fragments, path(i), {.provenance = "p"});
      EXPECT_TRUE(report) << report.error().message;
      paths.insert(paths.begin(), path(i)); // Their order does not matter.
    }
    return wordsOf(constructor.merge(paths));
  }

  /// The same by a tree of merges, two or three fragments a step, of shares as uneven as may be.
  Words mergedByTree(const Constructor &constructor, const Format &format, VoxelSource &source,
                     std::uint64_t memory) {
    const std::uint64_t cubes = partNumbersOf(source, format).count;
    std::vector<std::uint64_t> cuts = {0, cubes};
    while (cuts.size() < 8)
      cuts.push_back(random_() % (cubes + 1));
    std::ranges::sort(cuts);
    std::uint64_t files = 0;
    std::vector<std::string> paths;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      paths.push_back(path(files++));
      const auto report = constructor.buildFragment(source, {i, cuts.size() - 1, cuts[i], cuts[i + 1]},
                                                    paths.back(), {.provenance = "p"});
      EXPECT_TRUE(report) << report.error().message;
    }
    const BuildOptions options{.memory = WorkingMemory::create(memory)};
    while (paths.size() > 2) {
      std::vector<std::string> next;
      std::vector<std::uint64_t> nextCuts;
      const std::size_t step = paths.size() == 3 ? 2 : 3;
      const std::size_t count = (paths.size() + step - 1) / step;
      for (std::size_t i = 0; i < paths.size(); i += step) {
        const std::size_t end = std::min(i + step, paths.size());
        next.push_back(path(files++));
        nextCuts.push_back(cuts[i]);
        const auto joined =
            constructor.joinFragments({paths.begin() + static_cast<std::ptrdiff_t>(i),
                                       paths.begin() + static_cast<std::ptrdiff_t>(end)},
                                      {i / step, count, cuts[i], cuts[end]}, next.back(), options);
        EXPECT_TRUE(joined) << joined.error().message;
      }
      nextCuts.push_back(cubes);
      paths = next;
      cuts = nextCuts;
    }
    return wordsOf(constructor.merge(paths, options));
  }

  void expectSameBytes(const Format &format, const test::HardScene &scene) {
    const auto constructor = Constructor::compile(format);
    ASSERT_TRUE(constructor) << constructor.error().message;
    ChunkedSource whole(scene, 6);
    const auto expected = constructor->build(whole);
    const Words words = wordsOf(expected);
    for (const auto &[log2Chunk, threads] : {std::pair(3, 7u), std::pair(4, 2u)}) {
      ChunkedSource source(scene, log2Chunk);
      const auto built = constructor->build(source, {.threads = threads});
      EXPECT_EQ(wordsOf(built), words) << toString(format) << " " << scene.name;
      EXPECT_EQ(built->report.voxels, expected->report.voxels);
      for (std::size_t i = 0; i < built->report.levels.size(); ++i) {
        EXPECT_EQ(built->report.levels[i].uniqueNodes, expected->report.levels[i].uniqueNodes);
        EXPECT_EQ(built->report.levels[i].sharedNodes, expected->report.levels[i].sharedNodes)
            << toString(format) << " " << scene.name << " level " << i + 1;
      }
    }
    ChunkedSource source(scene, 3);
    EXPECT_EQ(merged(*constructor, source, 5), words) << toString(format) << " " << scene.name;
    for (const std::uint64_t memory : {1 << 12, 1 << 28})
      EXPECT_EQ(mergedByTree(*constructor, format, source, memory), words)
          << toString(format) << " " << scene.name;
  }

  std::filesystem::path folder_;
  std::mt19937 random_{5};
};

Format formatWith(std::string_view text, std::string_view passes) {
  auto format = parseFormat(text);
  EXPECT_TRUE(format) << format.error().message;
  Diagnostics diagnostics;
  for (const Pass &pass : voxc::passes())
    if (passes.find(pass.name) != passes.npos)
      pass.run(*format, diagnostics);
  return *format;
}

TEST_F(Parts, GiveTheSameBytesInEveryFormat) {
  // Formats take turns at the scenes: all of them for each would take minutes.
  constexpr std::size_t kEvery = 4;
  std::size_t turn = 0;
  for (const char *text : {"G(5)", "S(5)", "R(5^3)", "D(5^3,6)", "R(1^3) G(4)", "G(2) R(3^3)", "S(3) S(2)",
                           "D(1^3,6) D(4^3,3)", "R(2,3,5)", "S(0) G(5)", "G(2) G(0) G(3)",
                           "R(1^3) S(3) D(1^3,2)", "S(0) G(0)", "R(0^3)", "G(1)", "D(2,3,1,4) G(2)"})
    for (const char *passes : {"", "whole-level-dedup share-grids"}) {
      const Format format = formatWith(text, passes);
      const auto scenes = test::hardScenes(format.extent());
      for (std::size_t i = turn++ % kEvery; i < scenes.size(); i += kEvery)
        expectSameBytes(format, scenes[i]);
    }
}

TEST_F(Parts, GiveTheSameBytesForRandomFormats) {
  std::mt19937 random(11);
  for (int i = 0; i < test::rounds(12); ++i) {
    const Format format = test::randomFormat(random, test::pick(random, 4, 5));
    const auto scenes = test::hardScenes(format.extent());
    expectSameBytes(format, scenes[test::pick(random, 0, static_cast<int>(scenes.size()) - 1)]);
  }
}

TEST_F(Parts, GiveTheSameBytesInLittleMemory) {
  const auto source = makeBuiltinSource("terrain", 128);
  ASSERT_TRUE(source);
  for (const char *text : {"G(7)", "D(7^3,6)", "R(2^3) D(5^3,9)", "S(7)"}) {
    const auto constructor = Constructor::compile(formatWith(text, "whole-level-dedup"));
    const Words words = wordsOf(constructor->build(**source));
    const auto memory = WorkingMemory::create(1 << 18);
    EXPECT_EQ(wordsOf(constructor->build(**source, {.memory = memory})), words) << text;
    EXPECT_GT(memory->scratchPeak(), 0u);
  }
}

TEST_F(Parts, StreamTheSameFile) {
  const auto source = makeBuiltinSource("terrain", 64);
  const auto constructor = Constructor::compile(formatWith("R(2^3) G(4)", "whole-level-dedup"));
  const auto inMemory = constructor->build(**source, {.provenance = "p"});
  ASSERT_TRUE(inMemory);
  ASSERT_TRUE(inMemory->volume.save(path(0)));
  const auto streamed = constructor->build(**source, {.provenance = "p", .path = path(1)});
  ASSERT_TRUE(streamed) << streamed.error().message;
  EXPECT_EQ(readTextFile(path(0)).operator*(), readTextFile(path(1)).operator*());
  const auto loaded = Volume::load(path(1));
  ASSERT_TRUE(loaded) << loaded.error().message;
}

TEST_F(Parts, NamesWhatIsWrongWithASetOfFragments) {
  const auto source = makeBuiltinSource("terrain", 64);
  const auto constructor = Constructor::compile(formatWith("R(2^3) G(4)", ""));
  for (const std::uint64_t i : {0, 1, 2})
    ASSERT_TRUE(constructor->buildFragment(**source, i, 3, path(i)));
  ASSERT_TRUE(constructor->buildFragment(**source, 1, 2, path(3)));
  const auto problem = [&](std::vector<std::string> paths) {
    const auto built = constructor->merge(paths);
    return built ? std::string() : built.error().message;
  };
  EXPECT_EQ(problem({path(0), path(1), path(2)}), "");
  EXPECT_EQ(problem({}), "there is no fragment to merge");
  EXPECT_EQ(problem({path(0), path(2)}), "fragment 1 of 3 is missing");
  EXPECT_EQ(problem({path(0), path(1)}), "fragment 2 of 3 is missing");
  EXPECT_THAT(problem({path(0), path(1), path(1), path(2)}),
              ::testing::EndsWith("are the same fragment, 1 of 3"));
  EXPECT_THAT(problem({path(0), path(3)}), ::testing::EndsWith("are fragments of different volumes"));
  const auto other = Constructor::compile(formatWith("G(6)", ""));
  const auto merged = other->merge({path(0), path(1), path(2)});
  ASSERT_FALSE(merged);
  EXPECT_EQ(merged.error().message, "the fragments are of the format R(2, 2, 2) G(4), not G(6)");
}

/// Whatever is changed in a fragment, merging ends in a volume or an error.
TEST_F(Parts, BrokenFragmentsAreErrors) {
  const auto source = makeBuiltinSource("corners", 16);
  const auto constructor = Constructor::compile(formatWith("R(1^3) S(1) G(2)", ""));
  ASSERT_TRUE(constructor->buildFragment(**source, 0, 1, path(0)));
  const std::string bytes = *readTextFile(path(0));
  constexpr std::size_t kChecksum = 16;
  constexpr std::size_t kHeader = 200;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string broken = bytes;
    broken[i] ^= static_cast<char>(1 << i % 8);
    ASSERT_TRUE(writeFile(path(1), broken));
    EXPECT_FALSE(constructor->merge({path(1)})) << "byte " << i;
    ASSERT_TRUE(writeFile(path(1), std::string_view(bytes).substr(0, i)));
    EXPECT_FALSE(constructor->merge({path(1)})) << "cut at byte " << i;
    EXPECT_FALSE(constructor->joinFragments({path(1)}, {0, 1, 0, 8}, path(2)));
    std::memset(broken.data() + kChecksum, 0, sizeof(std::uint64_t));
    const std::string summed = broken.substr(kHeader) + broken.substr(0, kHeader);
    const std::uint64_t checksum = XXH3_64bits(summed.data(), summed.size());
    std::memcpy(broken.data() + kChecksum, &checksum, sizeof checksum);
    ASSERT_TRUE(writeFile(path(1), broken));
    const auto built =
        constructor->merge({path(1)}); // Must only not crash: not every change is a contradiction.
    const auto joined = constructor->joinFragments({path(1)}, {0, 1, 0, 8}, path(2));
  }
}

} // namespace
} // namespace voxc
