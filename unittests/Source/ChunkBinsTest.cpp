// Bins of records: their order, and which cubes are empty.
#include "Source/ChunkBins.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace voxc {
namespace {

using Bins = ChunkBins<std::uint32_t>;

TEST(ChunkBins, ChunksAreFewAndNotTooSmall) {
  EXPECT_EQ(Bins::log2ChunkFor({1, 1, 1}, 6), 6);
  EXPECT_EQ(Bins::log2ChunkFor({8192, 1, 1}, 6), 6);
  EXPECT_EQ(Bins::log2ChunkFor({8192, 1, 8193}, 6), 7);
  EXPECT_EQ(Bins::log2ChunkFor({1 << 21, 1 << 21, 1 << 21}, 6), 14);
  EXPECT_EQ(Bins::log2ChunkFor({65, 64, 1}, 3, 3), 4);
}

/// Bins of chunks of 8 cells in 100x20x50 cells, filled at random, and what they hold.
struct Filled {
  static constexpr Int3 kExtent{100, 20, 50};
  static constexpr Int3 kChunks{13, 3, 7};

  Filled() {
    std::mt19937 random(1);
    std::vector<Int3> chunks;
    for (int i = 0; i < 300; ++i)
      chunks.push_back({static_cast<int>(random() % 13), static_cast<int>(random() % 2),
                        static_cast<int>(random() % 3 * 3)});
    for (const Int3 chunk : chunks)
      bins.count(chunk);
    EXPECT_TRUE(bins.allocate());
    for (std::uint32_t i = 0; i < chunks.size(); ++i) {
      bins.place(chunks[i], i);
      expected[mortonCode(chunks[i])].push_back(i);
    }
  }

  Bins bins = *Bins::create(kExtent, 3, WorkingMemory::create(1 << 20));
  std::vector<std::vector<std::uint32_t>> expected{std::size_t{1} << 12};
};

TEST(ChunkBins, KeepsWhatCameInItsOrder) {
  const Filled filled;
  EXPECT_EQ(filled.bins.size(), 300u);
  for (Int3 chunk; chunk.z < Filled::kChunks.z; ++chunk.z)
    for (chunk.y = 0; chunk.y < Filled::kChunks.y; ++chunk.y)
      for (chunk.x = 0; chunk.x < Filled::kChunks.x; ++chunk.x) {
        const auto records = filled.bins.at(chunk);
        EXPECT_EQ(std::vector<std::uint32_t>(records.begin(), records.end()),
                  filled.expected[mortonCode(chunk)]);
      }
}

TEST(ChunkBins, EmptyCubesAreThoseWithoutARecord) {
  const Filled filled;
  for (int log2Side = 3; log2Side <= 7; ++log2Side) {
    const std::uint64_t chunks = std::uint64_t{1} << 3 * (log2Side - 3);
    for (std::uint64_t code = 0; code < filled.expected.size(); code += chunks) {
      bool isEmpty = true;
      for (std::uint64_t i = 0; i < chunks; ++i)
        isEmpty = isEmpty && filled.expected[code + i].empty();
      EXPECT_EQ(filled.bins.empty({mortonCell(code) * 8, log2Side}), isEmpty);
    }
  }
}

} // namespace
} // namespace voxc
