// The voxels of one chunk, in bricks that exist where there is something.
#pragma once

#include "Mesh/Voxelize/VoxelMean.h"
#include "voxc/Support/Geometry.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace voxc {

/// An aligned cube of voxels, each with its word and the distance of what gave it.
class ChunkVoxels {
public:
  static constexpr int kLog2Brick = 3;
  static constexpr int kMostLog2Side = 6;

  /// `log2Side`: kLog2Brick to kMostLog2Side.
  explicit ChunkVoxels(int log2Side);

  /// Becomes the chunk with this low corner, without a voxel.
  void clear(Int3 low);

  /// Position of a voxel of the chunk in Morton order.
  std::uint32_t codeOf(Int3 voxel) const {
    const Int3 at = voxel - low_;
    return spread_[static_cast<std::size_t>(at.x)] | spread_[static_cast<std::size_t>(at.y)] << 1 |
           spread_[static_cast<std::size_t>(at.z)] << 2;
  }

  /// True unless the voxel at `code` has a word that came with at most this distance.
  bool isNearer(std::uint32_t code, std::uint32_t distance) const {
    const Brick *brick = table_[code >> 3 * kLog2Brick];
    return !brick || distance < brick->distances[code & (kBrickCells - 1)];
  }

  /// Gives the voxel at `code` a word, which is not 0, and its distance, below 2^32 - 1.
  void set(std::uint32_t code, std::uint32_t distance, std::uint32_t word) {
    Brick *&brick = table_[code >> 3 * kLog2Brick];
    if (!brick)
      brick = addBrick();
    brick->distances[code & (kBrickCells - 1)] = distance;
    brick->words[code & (kBrickCells - 1)] = word;
  }

  /// The word of the voxel at `code`, which has one.
  std::uint32_t wordAt(std::uint32_t code) const {
    return table_[code >> 3 * kLog2Brick]->words[code & (kBrickCells - 1)];
  }

  /// Changes that word, to one that is not 0.
  void setWord(std::uint32_t code, std::uint32_t word) {
    table_[code >> 3 * kLog2Brick]->words[code & (kBrickCells - 1)] = word;
  }

  /// The mean of the voxel at `code`, which has a word.
  VoxelMean &meanAt(std::uint32_t code) {
    Brick &brick = *table_[code >> 3 * kLog2Brick];
    if (!brick.hasMeans)
      addMeans(brick);
    return (*brick.means)[code & (kBrickCells - 1)];
  }

  /// Makes that mean empty, if there is one.
  void clearMean(std::uint32_t code) {
    Brick &brick = *table_[code >> 3 * kLog2Brick];
    if (brick.hasMeans)
      (*brick.means)[code & (kBrickCells - 1)].clear();
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
    std::unique_ptr<std::array<VoxelMean, kBrickCells>> means; ///< Made when they are first asked for.
    bool hasMeans = false;                                     ///< They are this chunk's.
  };

  Brick *addBrick();
  static void addMeans(Brick &brick);

  Int3 low_;
  std::array<std::uint32_t, 1 << kMostLog2Side> spread_; ///< `spreadBits` of each coordinate.
  std::vector<Brick *> table_;                           ///< In Morton order; null without a voxel.
  std::vector<std::unique_ptr<Brick>> bricks_;           ///< Some of them used.
  std::size_t used_ = 0;
};

} // namespace voxc
