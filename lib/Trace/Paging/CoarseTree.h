// Which blocks of a volume have voxels, as a tree of eight children a node, so that rays find the first that
// they meet.
#pragma once

#include "voxc/Volume/CoarseBlocks.h"

#include <bit>
#include <cstdint>
#include <vector>

namespace voxc {

/// Takes 8 bytes for each block, and as many for each node above them.
class CoarseTree {
public:
  /// Of the blocks of a format of 2^log2Extent voxels on its longest axis.
  CoarseTree(const CoarseBlocks &blocks, int log2Extent);

  struct Block {
    std::uint32_t rgba = 0;
    std::uint32_t box = 0; ///< `packBox`.
  };
  struct Node {
    std::uint32_t firstChild = 0; ///< Of the layer below; its other children stand behind that.
    std::uint32_t octants = 0;    ///< A bit for each child that there is, in Morton order.

    /// Where the child in an octant stands.
    std::uint32_t child(unsigned octant) const {
      return firstChild + static_cast<std::uint32_t>(std::popcount(octants & ((1u << octant) - 1)));
    }
  };

  int log2Side() const { return log2Side_; }
  /// The root is node 0 of this layer, and blocks are the children of layer 1.
  int layers() const { return static_cast<int>(layers_.size()); }
  bool empty() const { return blocks_.empty(); }
  const Node &node(int layer, std::uint32_t index) const {
    return layers_[static_cast<std::size_t>(layer - 1)][index];
  }
  const Block &block(std::uint32_t index) const { return blocks_[index]; }

  std::uint64_t blocks() const { return blocks_.size(); }
  std::uint64_t bytes() const;

private:
  int log2Side_;
  std::vector<Block> blocks_;
  std::vector<std::vector<Node>> layers_; ///< From the lowest.
};

} // namespace voxc
