// The columns of the terrain, eight by eight, each computed once and kept for a while.
#pragma once

#include "Source/Builtin/TerrainShape.h"

#include <array>
#include <cstdint>
#include <vector>

namespace voxc {

/// What a column of the terrain is made of.
struct TerrainColumn {
  int ground;
  int surface; ///< Of the ground or the water.
  int bottom;  ///< The lowest voxel that can be seen.
  int drop;    ///< How far the lowest neighbour's ground lies below.
};

class TerrainColumns {
public:
  explicit TerrainColumns(const TerrainShape &shape) : shape_(shape), blocks_(kBlocks) {}

  /// The column at a place within the extent.
  const TerrainColumn &at(int x, int z);

private:
  static constexpr int kLog2Block = 3;
  static constexpr int kBlock = 1 << kLog2Block;
  /// Morton order comes back to a block within a region of 64 by 64 blocks, or seldom.
  static constexpr std::size_t kBlocks = 64 * 64;

  struct Block {
    int x = -1;
    int z = -1;
    std::array<TerrainColumn, kBlock * kBlock> columns;
  };

  void fill(Block &block) const;

  const TerrainShape &shape_;
  std::vector<Block> blocks_;
};

} // namespace voxc
