// The tree over the blocks of a volume that have voxels.
#include "CoarseTree.h"

#include <algorithm>

namespace voxc {

CoarseTree::CoarseTree(const CoarseBlocks &blocks, int log2Extent) : log2Side_(blocks.log2Side) {
  std::vector<std::uint64_t> codes;
  codes.reserve(blocks.blocks.size());
  blocks_.reserve(blocks.blocks.size());
  for (const CoarseBlock &block : blocks.blocks) {
    codes.push_back(block.code);
    blocks_.push_back({block.rgba, block.box});
  }
  // At least one layer, so that there is a root.
  for (int layer = 1; layer <= std::max(log2Extent - log2Side_, 1); ++layer) {
    std::vector<Node> nodes;
    std::vector<std::uint64_t> above;
    for (std::size_t i = 0; i < codes.size(); ++i) {
      if (above.empty() || above.back() != codes[i] >> 3) {
        above.push_back(codes[i] >> 3);
        nodes.push_back({static_cast<std::uint32_t>(i), 0});
      }
      nodes.back().octants |= 1u << (codes[i] & 7);
    }
    nodes.shrink_to_fit();
    layers_.push_back(std::move(nodes));
    codes = std::move(above);
  }
}

std::uint64_t CoarseTree::bytes() const {
  std::uint64_t nodes = 0;
  for (const std::vector<Node> &layer : layers_)
    nodes += layer.size();
  return blocks_.size() * sizeof(Block) + nodes * sizeof(Node);
}

} // namespace voxc
