// Coarse blocks of volumes: the means and the boxes of their voxels, kept in files, and files that have
// others.
#include "PagingTesting.h"

#include "voxc/Volume/Attributes.h"
#include "voxc/Volume/CoarseBlocks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>

namespace voxc {
namespace {

using namespace test;
using ::testing::HasSubstr;

struct Gathered {
  std::uint64_t voxels = 0;
  std::array<std::uint64_t, 4> sums{};
  CoarseBox box;
};

/// What blocks ought to be, voxel by voxel.
CoarseBlocks expectedBlocks(const HardScene &scene, int log2Side) {
  std::map<std::uint64_t, Gathered> found;
  const std::int32_t inside = (1 << log2Side) - 1;
  for (Int3 at; at.z < scene.extent.z; ++at.z)
    for (at.y = 0; at.y < scene.extent.y; ++at.y)
      for (at.x = 0; at.x < scene.extent.x; ++at.x) {
        const std::uint32_t word = scene.voxel(at);
        if (word == 0)
          continue;
        Gathered &block = found[mortonCode(at >> log2Side)];
        for (int axis = 0; axis < 3; ++axis) {
          const std::int32_t place = at[axis] & inside;
          block.box.low[axis] = block.voxels == 0 ? place : std::min(block.box.low[axis], place);
          block.box.high[axis] = block.voxels == 0 ? place : std::max(block.box.high[axis], place);
        }
        for (std::size_t channel = 0; channel < 4; ++channel)
          block.sums[channel] += word >> 8 * channel & 0xff;
        ++block.voxels;
      }
  CoarseBlocks blocks{log2Side, {}};
  for (const auto &[code, block] : found) {
    std::uint32_t mean = 0;
    for (std::size_t channel = 0; channel < 4; ++channel)
      mean |= static_cast<std::uint32_t>((2 * block.sums[channel] + block.voxels) / (2 * block.voxels))
              << 8 * channel;
    blocks.blocks.push_back({code, mean, packBox(block.box)});
  }
  return blocks;
}

class Coarse : public Paging {
protected:
  static std::shared_ptr<const Volume> volumeOf(const char *text, const HardScene &scene) {
    auto volume = build(*parseFormat(text), scene);
    EXPECT_TRUE(volume) << volume.error().message;
    return std::make_shared<const Volume>(std::move(*volume));
  }

  /// A file of a volume with such blocks, whatever they are.
  Expected<CoarseBlocks> reread(const CoarseBlocks &blocks) {
    auto volume = withCoarseBlocks(volume_, blocks);
    if (!volume)
      return volume.error();
    return readCoarseBlocks(paged(*volume));
  }

  std::string refusal(CoarseBlocks blocks) {
    const auto read = reread(blocks);
    const auto found = coarseBlocksOf(*withCoarseBlocks(volume_, blocks));
    EXPECT_EQ(bool(read), bool(found));
    return read ? "" : read.error().message;
  }

  const std::shared_ptr<const Volume> volume_ =
      volumeOf("format { level 1: svdag(6) }", noise({64, 64, 64}, 5));
};

TEST_F(Coarse, BlocksAreTheMeansOfTheirVoxels) {
  const auto ball = [](Int3 at) {
    const Int3 from = at - Int3{30, 30, 30};
    return from.x * from.x + from.y * from.y + from.z * from.z < 800 ? 0xff102030u : 0u;
  };
  const HardScene scenes[] = {noise({64, 64, 64}, 3),
                              {"ball", ball, {}, {64, 60, 50}},
                              {"full", [](Int3) { return 7u; }, {}, {64, 64, 64}}};
  for (const HardScene &scene : scenes)
    for (const char *text : {"format { level 1: svdag(6) }", "format { level 1: raw(6, 6, 6) }",
                             "format values=apart { level 1: raw(1, 1, 1) level 2: masked(5, 5, 5) }",
                             "format { level 1: raw(2, 2, 2) level 2: hash(4, 4, 4) }"}) {
      const auto volume = volumeOf(text, scene);
      for (int log2Side = kLeastLog2CoarseSide; log2Side <= kMostLog2CoarseSide; ++log2Side) {
        const auto blocks = makeCoarseBlocks(*volume, log2Side);
        ASSERT_TRUE(blocks) << blocks.error().message;
        EXPECT_TRUE(*blocks == expectedBlocks(scene, log2Side)) << scene.name << text << log2Side;
      }
    }
}

TEST_F(Coarse, BlocksOfSmallAndOfEmptyVolumesAreFew) {
  const HardScene dot = {
      "dot", [](Int3 at) { return at == Int3{1, 0, 1} ? 0x01020304u : 0u; }, {}, {2, 2, 2}};
  const auto one = makeCoarseBlocks(*volumeOf("format { level 1: raw(1, 1, 1) }", dot), 4);
  ASSERT_TRUE(one);
  ASSERT_EQ(one->blocks.size(), 1u);
  EXPECT_EQ(one->blocks[0], (CoarseBlock{0, 0x01020304u, packBox({{1, 0, 1}, {1, 0, 1}})}));
  const HardScene none = {"none", [](Int3) { return 0u; }, {}, {2, 2, 2}};
  const auto empty = volumeOf("format { level 1: raw(1, 1, 1) }", none);
  EXPECT_TRUE(makeCoarseBlocks(*empty, 3)->blocks.empty());
  const auto kept = readCoarseBlocks(paged(*withCoarseBlocks(empty, {3, {}})));
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_TRUE(kept->blocks.empty());
}

TEST_F(Coarse, BlocksOfLabelsAreRefused) {
  const HardScene labels = {"labels", [](Int3) { return 3u; }, {}, {4, 4, 4}};
  const auto volume =
      volumeOf("format payload=material(4) values=apart { level 1: masked(2, 2, 2) }", labels);
  const auto blocks = makeCoarseBlocks(*volume, 2);
  ASSERT_FALSE(blocks);
  EXPECT_THAT(blocks.error().message, HasSubstr("labels, which have no mean"));
}

TEST_F(Coarse, BlocksAreKeptInFiles) {
  const CoarseBlocks fine = *makeCoarseBlocks(*volume_, 2), coarse = *makeCoarseBlocks(*volume_, 4);
  const auto kept = reread(fine);
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_TRUE(*kept == fine);
  auto loaded = Volume::load(path_);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_TRUE(*coarseBlocksOf(*loaded) == std::optional(fine));
  // Others take their place.
  const auto again = withCoarseBlocks(std::make_shared<const Volume>(std::move(*loaded)), coarse);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->streams().size(), 2u);
  EXPECT_TRUE(*coarseBlocksOf(*again) == std::optional(coarse));
  EXPECT_FALSE(coarseBlocksOf(*volume_)->has_value());
  const auto none = readCoarseBlocks(paged(*volume_));
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("voxc export --compress --coarse 8"));
}

TEST_F(Coarse, BlocksThatCannotBeAreRefused) {
  const CoarseBlocks right = *makeCoarseBlocks(*volume_, 3);
  EXPECT_EQ(refusal(right), "");
  const auto with = [&](std::size_t index, CoarseBlock block) {
    CoarseBlocks wrong = right;
    wrong.blocks[index] = block;
    return refusal(wrong);
  };
  const CoarseBlock last = right.blocks.back();
  EXPECT_THAT(with(1, right.blocks[0]), HasSubstr("number 1, that does not come after the one before it"));
  EXPECT_THAT(with(right.blocks.size() - 1, {512, 1, last.box}), HasSubstr("outside of the format"));
  EXPECT_THAT(with(right.blocks.size() - 1, {~std::uint64_t{0}, 1, last.box}), HasSubstr("outside"));
  EXPECT_THAT(with(0, {0, 1, packBox({{2, 0, 0}, {1, 7, 7}})}), HasSubstr("in no box within it"));
  EXPECT_THAT(with(0, {0, 1, packBox({{0, 0, 0}, {1, 8, 1}})}), HasSubstr("in no box within it"));
  EXPECT_THAT(with(0, {0, 1, 1u << 30}), HasSubstr("in no box within it"));
  EXPECT_THAT(refusal({3, {}}), HasSubstr("has 0 coarse blocks, which cannot be for"));
  CoarseBlocks many{2, std::vector<CoarseBlock>(volume_->info().voxels + 1)};
  EXPECT_THAT(refusal(many), HasSubstr("which cannot be for"));
}

TEST_F(Coarse, BlocksOfAnotherSizeOrDamagedAreRefused) {
  const std::vector<std::byte> bytes(40);
  std::vector<Stream> streams = {wordStream(volume_->words()), {"coarse-8", 8, bytes}};
  const auto odd = readCoarseBlocks(paged(Volume(volume_->info(), streams, nullptr)));
  ASSERT_FALSE(odd);
  EXPECT_THAT(odd.error().message, HasSubstr("has coarse blocks of 8 bytes, not 16"));
  ASSERT_TRUE(reread(*makeCoarseBlocks(*volume_, 3)));
  const auto end = static_cast<std::streamoff>(std::filesystem::file_size(path_)) - 1;
  std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
  file.seekg(end);
  const int byte = file.get();
  file.seekp(end);
  file.put(static_cast<char>(byte ^ 1));
  file.close();
  const auto damaged = readCoarseBlocks(*PagedVolume::open(path_));
  ASSERT_FALSE(damaged);
  EXPECT_THAT(damaged.error().message, HasSubstr("of stream 'coarse-8' is not what was stored"));
}

} // namespace
} // namespace voxc
