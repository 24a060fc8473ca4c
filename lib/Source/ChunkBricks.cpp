// Bricks of a chunk: filling and reading them.
#include "Source/ChunkBricks.h"

#include "Source/CubeTools.h"

#include <algorithm>

namespace voxc {

void ChunkBricks::fill(std::span<const CodedVoxel> voxels) {
  occupied_.fill(0);
  used_ = 0;
  for (const CodedVoxel &voxel : voxels) {
    const std::uint64_t brick = voxel.code / kBrickVoxels % kBricks;
    std::uint32_t *const words = isOccupied(brick) ? &words_[places_[brick] * kBrickVoxels] : open(brick);
    std::uint32_t &word = words[voxel.code % kBrickVoxels];
    if (word == 0)
      word = voxel.word;
  }
}

std::uint32_t *ChunkBricks::open(std::uint64_t brick) {
  const std::size_t begin = std::size_t{used_} * kBrickVoxels;
  if (begin == words_.size())
    words_.resize(std::max<std::size_t>(2 * begin, kBrickVoxels));
  std::fill_n(&words_[begin], kBrickVoxels, 0u);
  occupied_[brick / 64] |= std::uint64_t{1} << brick % 64;
  places_[brick] = used_++;
  return &words_[begin];
}

bool ChunkBricks::empty(const Cube &cube) const {
  const std::uint64_t code = mortonCode(cube.low);
  const std::uint64_t brick = code / kBrickVoxels % kBricks;
  if (cube.log2Side >= kLog2Brick) {
    // The bricks of an aligned cube are 1, 8 or 64 bits that follow one another.
    const std::uint64_t count = cellCount(cube.log2Side - kLog2Brick);
    const std::uint64_t all = count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
    return (occupied_[brick / 64] >> brick % 64 & all) == 0;
  }
  if (!isOccupied(brick))
    return true;
  const std::uint32_t *const words = wordsOf(brick) + code % kBrickVoxels;
  return std::all_of(words, words + cellCount(cube.log2Side), [](std::uint32_t word) { return word == 0; });
}

void ChunkBricks::read(const Cube &cube, std::uint32_t *words) const {
  const std::uint64_t code = mortonCode(cube.low);
  const std::uint64_t brick = code / kBrickVoxels % kBricks;
  if (isOccupied(brick))
    std::copy_n(wordsOf(brick) + code % kBrickVoxels, cellCount(cube.log2Side), words);
  else
    std::fill_n(words, cellCount(cube.log2Side), 0u);
}

} // namespace voxc
