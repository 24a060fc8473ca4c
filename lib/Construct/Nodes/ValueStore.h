// The values of voxels that stand apart, while a volume is built: taken by rank, kept as blocks.
#pragma once

#include "ColourTable.h"
#include "NodeStore.h"

#include "voxc/Layout/Layout.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace voxc {

/// Encodes values as they come, as the payload asks for; equal blocks are kept once where they are
/// remembered. What goes wrong, fails the store of the nodes.
class ValueStore {
public:
  ValueStore(NodeStore &nodes, VoxelFacts facts, const std::shared_ptr<WorkingMemory> &memory);

  /// Takes the values of the voxels of the next ranks. More than 2^32 - 1 in all are an error, and so is a
  /// colour for which a palette has no room: who knows the voxels has looked before.
  void put(std::span<const std::uint32_t> values);

  /// Different colours so far, where they are in a palette; else 0.
  std::size_t colours() const { return palette_ ? palette_->colours().size() : 0; }

  /// Appends the section of all blocks (voxc/Layout/Values.h) to words, of which there are then at most
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
  void encodeIndices();
  void keepBlock(std::span<const std::uint32_t> block, std::uint64_t before);
  void tell(std::uint64_t begin);
  void append(WordStore &words, std::span<const std::uint32_t> more);
  void packTable(std::uint64_t colours, int bits);
  bool keep(const Expected<void> &done);

  NodeStore &nodes_;
  std::uint32_t (*code_)(std::uint32_t colour); ///< As of `PayloadKind`.
  ScratchArray<std::uint32_t> blocks_;
  ScratchArray<std::uint32_t> begins_; ///< Of each block, in `blocks_`; see `encodeIndices`.
  std::optional<ColourTable> palette_;
  std::vector<Known> known_;
  std::vector<std::uint32_t> pending_; ///< Of the next block.
};

} // namespace voxc
