// The values of voxels that stand apart, while a volume is built: taken by rank, kept as blocks.
#pragma once

#include "NodeStore.h"

#include "voxc/Layout/ValueBlocks.h"

#include <memory>
#include <span>
#include <vector>

namespace voxc {

/// Encodes values as they come; equal blocks are kept once where they are remembered. What goes wrong, fails
/// the store of the nodes.
class ValueStore {
public:
  ValueStore(NodeStore &nodes, const std::shared_ptr<WorkingMemory> &memory)
      : nodes_(nodes), blocks_(memory), begins_(memory), known_(kKnown) {}

  /// Takes the values of the voxels of the next ranks. More than 2^32 - 1 in all are an error.
  void put(std::span<const std::uint32_t> values);

  /// Appends the section of all blocks (voxc/Layout/ValueBlocks.h) to words, of which there are then at most
  /// `maxWords`. Nothing can be put afterwards.
  void finish(WordStore &words, std::uint64_t maxWords);

private:
  /// Blocks are looked for among so many.
  static constexpr std::size_t kKnown = 4096;

  struct Known {
    std::uint64_t begin = 0;
    std::uint64_t words = 0;
  };

  void encode();
  bool keep(Expected<void> done);

  NodeStore &nodes_;
  ScratchArray<std::uint32_t> blocks_;
  ScratchArray<std::uint32_t> begins_; ///< Of each block, in `blocks_`.
  std::vector<Known> known_;
  std::vector<std::uint32_t> pending_; ///< Of the next block.
};

} // namespace voxc
