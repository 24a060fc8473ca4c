// Facts of scenes against their definitions, and what measuring does when it cannot go on.
#include "BruteForceFacts.h"

#include "Facts/Mix.h"
#include "TestLength.h"

#include "testing/HardScenes.h"
#include "voxc/Facts/Facts.h"
#include "voxc/Source/Sources.h"

#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <vector>

namespace voxc::test {
namespace {

void expectEqual(const ColourFacts &found, const ColourFacts &wanted) {
  EXPECT_EQ(found.words, wanted.words);
  EXPECT_EQ(found.rgb, wanted.rgb);
  EXPECT_TRUE(found.entropyExact);
  EXPECT_NEAR(found.entropy, wanted.entropy, 1e-9);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found.channels[i].least, wanted.channels[i].least) << i;
    EXPECT_EQ(found.channels[i].greatest, wanted.channels[i].greatest) << i;
    EXPECT_NEAR(found.channels[i].mean, wanted.channels[i].mean, 1e-6) << i;
  }
  EXPECT_EQ(found.alphas, wanted.alphas);
  EXPECT_EQ(found.opaque, wanted.opaque);
  EXPECT_EQ(found.transparent, wanted.transparent);
  EXPECT_EQ(found.repeats, wanted.repeats);
  EXPECT_NEAR(found.perBlock4, wanted.perBlock4, 1e-9);
  EXPECT_NEAR(found.perBlock8, wanted.perBlock8, 1e-9);
  EXPECT_NEAR(found.perRun256, wanted.perRun256, 1e-9);
}

void expectEqual(const Facts &found, const Facts &wanted) {
  EXPECT_EQ(found.extent, wanted.extent);
  EXPECT_EQ(found.log2Extent, wanted.log2Extent);
  EXPECT_EQ(found.voxels, wanted.voxels);
  EXPECT_EQ(found.boxLow, wanted.boxLow);
  EXPECT_EQ(found.boxHigh, wanted.boxHigh);
  EXPECT_EQ(found.interior, wanted.interior);
  EXPECT_EQ(found.heights, wanted.heights);
  EXPECT_EQ(found.regions.log2Side, wanted.regions.log2Side);
  EXPECT_EQ(found.regions.voxels, wanted.regions.voxels);
  expectEqual(found.colours, wanted.colours);
  ASSERT_EQ(found.repetition.size(), wanted.repetition.size());
  for (std::size_t i = 0; i < wanted.repetition.size(); ++i) {
    EXPECT_EQ(found.repetition[i].height, wanted.repetition[i].height);
    EXPECT_EQ(found.repetition[i].blocks, wanted.repetition[i].blocks) << i;
    EXPECT_EQ(found.repetition[i].shapes, wanted.repetition[i].shapes) << i;
    EXPECT_EQ(found.repetition[i].mirrored, wanted.repetition[i].mirrored) << i;
    EXPECT_EQ(found.repetition[i].coloured, wanted.repetition[i].coloured) << i;
  }
}

Facts factsOf(VoxelSource &source, const FactsOptions &options = {}) {
  Expected<Facts> facts = measureFacts(source, options);
  EXPECT_TRUE(facts);
  return facts ? *facts : Facts{};
}

/// Compares with the definitions.
void check(Int3 extent, const std::function<std::uint32_t(Int3)> &voxel) {
  const auto source = makeFunctionSource(extent, voxel);
  expectEqual(factsOf(*source), BruteForceFacts(extent, voxelsOf(extent, voxel)).measure());
}

/// A colour of one cell out of a few, the same at each call.
struct RandomScene {
  std::uint32_t seed;
  std::uint32_t percent;   // Of cells that are voxels.
  std::uint32_t colours;   // That voxels choose from.
  int log2Patch;           // Cells of a patch of 2^log2Patch a side are all alike.
  std::uint32_t alphaMask; // Of the alphas of colours, which are opaque but for these bits.

  std::uint32_t operator()(Int3 cell) const {
    const std::uint64_t choice = mix(mix(mortonCode(cell >> log2Patch) + 1) + seed);
    if (choice % 100 >= percent)
      return 0;
    const std::uint64_t colour = mix(seed + 1 + (choice >> 32) % colours);
    return (static_cast<std::uint32_t>(colour) | 0xff000001) &
           ~(alphaMask & static_cast<std::uint32_t>(colour >> 32));
  }
};

TEST(Facts, OfRandomScenesAreAsDefined) {
  std::mt19937 random(1);
  const auto upTo = [&](int most) { return 1 + static_cast<int>(random() % static_cast<unsigned>(most)); };
  constexpr std::array<std::uint32_t, 4> kColours{1, 3, 300, 1000000};
  constexpr std::array<std::uint32_t, 3> kAlphas{0, 0x80000000, 0xff000000};
  for (int round = 0; round < rounds(60); ++round) {
    const int most = std::array{4, 9, 20, 40}[static_cast<std::size_t>(round % 4)];
    const Int3 extent{upTo(most), upTo(most), upTo(most)};
    const RandomScene scene{static_cast<std::uint32_t>(random()), static_cast<std::uint32_t>(upTo(100)),
                            kColours[random() % 4], static_cast<int>(random() % 4), kAlphas[random() % 3]};
    SCOPED_TRACE(testing::Message() << "round " << round << ": " << extent.x << ' ' << extent.y << ' '
                                    << extent.z);
    check(extent, scene);
  }
}

TEST(Facts, OfHardScenesAreAsDefined) {
  for (const Int3 extent : {Int3{1, 1, 1}, Int3{2, 1, 4}, Int3{8, 8, 8}, Int3{17, 32, 9}, Int3{33, 20, 40}})
    for (const HardScene &scene : hardScenes(extent)) {
      SCOPED_TRACE(scene.name);
      check(extent, scene.voxel);
    }
}

TEST(Facts, OfBlocksOf64VoxelsAreAsDefined) {
  const Int3 extent{130, 10, 70};
  check(extent, RandomScene{5, 30, 4, 4, 0});
  check(extent, RandomScene{6, 3, 4, 0, 0});
}

// Each half is the other one in a mirror: shapes differ, mirrored ones do not.
TEST(Facts, MirroredBlocksAreOne) {
  const RandomScene scene{7, 40, 1, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    Int3 extent{64, 64, 64};
    extent[axis] = 128;
    const auto source = makeFunctionSource(extent, [&](Int3 cell) {
      cell[axis] = std::min(cell[axis], 127 - cell[axis]);
      return scene(cell);
    });
    const RepetitionFacts blocks = factsOf(*source).repetition[5];
    EXPECT_EQ(blocks.blocks, 2u);
    EXPECT_EQ(blocks.shapes.count, 2u);
    EXPECT_EQ(blocks.mirrored.count, 1u);
    EXPECT_EQ(blocks.coloured.count, 2u);
  }
}

// Many more bricks wait than the first table has room for.
TEST(Facts, InteriorOfLargeScenesIsExact) {
  const Int3 extent{128, 120, 128};
  const RandomScene scene{8, 95, 1, 0, 0};
  std::vector<std::uint32_t> words;
  for (Int3 cell; cell.z < extent.z; ++cell.z)
    for (cell.y = 0; cell.y < extent.y; ++cell.y)
      for (cell.x = 0; cell.x < extent.x; ++cell.x)
        words.push_back(scene(cell));
  std::uint64_t interior = 0;
  const int row = extent.x;
  const int layer = extent.x * extent.y;
  for (Int3 cell{1, 1, 1}; cell.z < extent.z - 1; ++cell.z)
    for (cell.y = 1; cell.y < extent.y - 1; ++cell.y)
      for (cell.x = 1; cell.x < extent.x - 1; ++cell.x) {
        const int at = cell.x + row * cell.y + layer * cell.z;
        interior += std::ranges::all_of(std::array{0, -1, 1, -row, row, -layer, layer}, [&](int step) {
          return words[static_cast<std::size_t>(at + step)] != 0;
        });
      }
  const auto source = makeGridSource(extent, std::move(words));
  EXPECT_EQ(factsOf(*source).interior, interior);
}

TEST(Facts, InteriorNeedsLittleMemory) {
  const auto box = makeFunctionSource({200, 200, 200}, [](Int3) { return 1u; });
  const auto memory = WorkingMemory::create(std::uint64_t{64} << 10);
  EXPECT_EQ(factsOf(*box, {.memory = memory}).interior, 198u * 198 * 198);
  EXPECT_GT(memory->scratchPeak(), 0u);
}

TEST(Facts, OfTheLargestExtent) {
  constexpr int kLast = (1 << kMaxLog2Extent) - 1;
  constexpr int kSide = kLast + 1;
  std::vector<CodedVoxel> voxels{{mortonCode({0, 0, 0}), 7}, {mortonCode({kLast, kLast, kLast}), 9}};
  const auto source = makeSortedSource({kSide, kSide, kSide}, std::move(voxels));
  const Facts facts = factsOf(*source);
  EXPECT_EQ(facts.log2Extent, kMaxLog2Extent);
  EXPECT_EQ(facts.boxLow, (Int3{0, 0, 0}));
  EXPECT_EQ(facts.boxHigh, (Int3{kSide, kSide, kSide}));
  EXPECT_EQ(facts.heights.back().occupied, 1u);
  EXPECT_EQ(facts.heights[kMaxLog2Extent - 1].occupied, 2u);
  EXPECT_EQ(facts.regions.voxels.front(), 1u);
  EXPECT_EQ(facts.regions.voxels.back(), 1u);
  EXPECT_DOUBLE_EQ(facts.branching(kMaxLog2Extent), 2);
  EXPECT_DOUBLE_EQ(facts.branching(1), 1);
}

TEST(Facts, BoundsOfWhatIsKeptAreTold) {
  const RandomScene scene{9, 50, 1000000, 0, 0};
  const Int3 extent{48, 48, 48};
  const Facts exact = BruteForceFacts(extent, voxelsOf(extent, scene)).measure();
  const auto source = makeFunctionSource(extent, scene);
  constexpr std::size_t kKept = 4096;
  const Facts facts = factsOf(*source, {.mostWords = kKept, .mostBlocks = kKept});
  const double five = 5 * 1.2 / std::sqrt(double(kKept)); // Standard errors.
  const auto expectNear = [&](const DistinctCount &found, const DistinctCount &wanted) {
    EXPECT_EQ(found.exact, wanted.count <= kKept);
    EXPECT_NEAR(double(found.count), double(wanted.count), found.exact ? 0 : five * double(wanted.count));
  };
  expectNear(facts.colours.words, exact.colours.words);
  expectNear(facts.colours.rgb, exact.colours.rgb);
  EXPECT_FALSE(facts.colours.words.exact);
  EXPECT_FALSE(facts.colours.entropyExact);
  EXPECT_LE(facts.colours.entropy, exact.colours.entropy);
  EXPECT_GT(facts.colours.entropy, 11.5);
  for (std::size_t i = 0; i < exact.repetition.size(); ++i) {
    expectNear(facts.repetition[i].shapes, exact.repetition[i].shapes);
    expectNear(facts.repetition[i].mirrored, exact.repetition[i].mirrored);
    expectNear(facts.repetition[i].coloured, exact.repetition[i].coloured);
  }
  EXPECT_FALSE(facts.repetition[1].coloured.exact && facts.repetition[0].coloured.exact);
}

TEST(Facts, OfNothing) {
  const auto source = makeFunctionSource({20, 3, 5}, [](Int3) { return 0u; });
  const Facts facts = factsOf(*source);
  EXPECT_EQ(facts.voxels, 0u);
  EXPECT_EQ(facts.fill(), 0);
  EXPECT_EQ(facts.interiorShare(), 0);
  EXPECT_EQ(facts.branching(1), 0);
  EXPECT_EQ(facts.colours.indexBits(), 0);
}

TEST(Facts, IndexBitsReachAllWords) {
  ColourFacts colours;
  for (const auto &[words, bits] : {std::pair{1u, 0}, {2u, 1}, {3u, 2}, {256u, 8}, {257u, 9}, {65536u, 16}}) {
    colours.words.count = words;
    EXPECT_EQ(colours.indexBits(), bits) << words;
  }
}

class FailingSource final : public VoxelSource {
public:
  Int3 extent() const override { return {64, 64, 64}; }
  bool empty(const Cube &) override { return false; }
  Expected<void> read(const Cube &, std::uint32_t *) override {
    return Error::environment("the disk is gone");
  }
};

TEST(Facts, FailureOfTheSourceIsPassedOn) {
  FailingSource source;
  const Expected<Facts> facts = measureFacts(source);
  ASSERT_FALSE(facts);
  EXPECT_EQ(facts.error().kind, ErrorKind::Environment);
  EXPECT_EQ(facts.error().message, "the disk is gone");
}

TEST(Facts, CanBeStopped) {
  const auto source = makeFunctionSource({64, 64, 64}, [](Int3) { return 1u; });
  std::atomic<bool> stop = false;
  Progress progress;
  progress.stop = &stop;
  progress.report = [&](std::string_view, double fraction, std::uint64_t) {
    EXPECT_GE(fraction, 0);
    EXPECT_LT(fraction, 1);
    stop = true;
  };
  const Expected<Facts> facts = measureFacts(*source, {}, progress);
  ASSERT_FALSE(facts);
  EXPECT_EQ(facts.error().kind, ErrorKind::Interrupted);
}

} // namespace
} // namespace voxc::test
