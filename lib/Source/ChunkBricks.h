// The voxels of one chunk as bricks of 8 voxels a side: what makes reading a list of voxels cheap.
#pragma once

#include "voxc/Source/Sources.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// The voxels of an aligned cube of 64 a side, those of each brick in Morton order.
class ChunkBricks {
public:
  static constexpr int kLog2Chunk = 6;
  static constexpr int kLog2Brick = 3;

  /// Takes the voxels of a chunk, in any order; the first of several with one code stays.
  void fill(std::span<const CodedVoxel> voxels);

  /// True if no voxel lies in `cube`, which lies in the chunk and is smaller.
  bool empty(const Cube &cube) const;
  /// Writes the words of `cube`, which lies in a brick.
  void read(const Cube &cube, std::uint32_t *words) const;

private:
  static constexpr unsigned kBrickVoxels = 512;
  static constexpr unsigned kBricks = 512;

  bool isOccupied(std::uint64_t brick) const { return occupied_[brick / 64] >> brick % 64 & 1; }
  const std::uint32_t *wordsOf(std::uint64_t brick) const { return &words_[places_[brick] * kBrickVoxels]; }
  std::uint32_t *open(std::uint64_t brick);

  std::array<std::uint64_t, kBricks / 64> occupied_{}; ///< A bit for each brick in Morton order.
  std::array<std::uint16_t, kBricks> places_{};        ///< Of an occupied brick in `words_`, in bricks.
  std::vector<std::uint32_t> words_;
  std::uint16_t used_ = 0; ///< Bricks of `words_`.
};

} // namespace voxc
