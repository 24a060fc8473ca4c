// The voxels of one chunk, in bricks that exist where there is something.
#pragma once

#include "voxc/Support/Geometry.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace voxc {

/// An aligned cube of voxels of which each keeps the word that was proposed with the smallest distance.
class ChunkVoxels {
public:
  static constexpr int kLog2Brick = 3;
  static constexpr int kMostLog2Side = 6;

  /// `log2Side`: kLog2Brick to kMostLog2Side.
  explicit ChunkVoxels(int log2Side);

  /// Becomes the chunk with this low corner, without a voxel.
  void clear(Int3 low);

  /// Gives `voxel`, which lies in the chunk, the word that `word()` makes, unless an earlier one came with at
  /// most this distance (below 2^32 - 1), or the word is 0. `word` is not called in vain.
  template <typename Word> void propose(Int3 voxel, std::uint32_t distance, Word word) {
    const std::uint32_t code = codeOf(voxel);
    Brick *&brick = table_[code >> 3 * kLog2Brick];
    const std::uint32_t cell = code & (kBrickCells - 1);
    if (brick && brick->distances[cell] <= distance)
      return;
    const std::uint32_t made = word();
    if (made == 0)
      return;
    if (!brick)
      brick = addBrick();
    brick->distances[cell] = distance;
    brick->words[cell] = made;
  }

  /// True if `cube`, in the chunk, holds no voxel.
  bool empty(const Cube &cube) const;
  /// Writes the words of `cube`, in the chunk and no larger than a brick, in Morton order.
  void read(const Cube &cube, std::uint32_t *words) const;

private:
  static constexpr std::uint32_t kBrickCells = 512;

  struct Brick {
    std::array<std::uint32_t, kBrickCells> words;
    std::array<std::uint32_t, kBrickCells> distances;
  };

  std::uint32_t codeOf(Int3 voxel) const {
    const Int3 at = voxel - low_;
    return spread_[static_cast<std::size_t>(at.x)] | spread_[static_cast<std::size_t>(at.y)] << 1 |
           spread_[static_cast<std::size_t>(at.z)] << 2;
  }
  Brick *addBrick();

  Int3 low_;
  std::array<std::uint32_t, 1 << kMostLog2Side> spread_; ///< `spreadBits` of each coordinate.
  std::vector<Brick *> table_;                           ///< In Morton order; null without a voxel.
  std::vector<std::unique_ptr<Brick>> bricks_;           ///< Some of them used.
  std::size_t used_ = 0;
};

} // namespace voxc
