// A part of a volume that was built apart, and how it joins the whole (docs/hvf.md).
#pragma once

#include "Construct/Nodes/NodeStore.h"

#include "voxc/Layout/Layout.h"
#include "voxc/Support/Geometry.h"

#include "voxc_host.h"

#include <cstdint>
#include <vector>

namespace voxc {

/// What an aligned cube of voxels became: words with offsets of its own, the order in which they were
/// written, and what the part above needs of it: a node of a tree, or the cells of a grid.
struct Fragment {
  Cube cube;
  std::vector<std::uint32_t> words;
  std::vector<BlockRecord>
      blocks; ///< Together they are `words`, but for the first word, which has no meaning.
  std::vector<std::uint32_t>
      array; ///< Of indexed sub-volumes, from number 0 on, whose blocks are not in `words`.
  construct::Node node;
  std::vector<construct::PlacedCell> cells;
  std::vector<std::uint32_t> values; ///< Those of the voxels, by rank, where they stand apart.
  std::uint64_t voxels = 0;
  std::uint32_t colour = 0; ///< Of all of them (`Layout::hasOneColour`).
};

/// Does again what building the fragment did, now at the end of `store`: every block is written or, if it is
/// shared and there already, found. What remains of the fragment, its node and cells, points there. The store
/// fails (`Input`) if the fragment contradicts itself.
class Splice {
public:
  Splice(const Layout &layout, NodeStore &store) : layout_(layout), store_(store) {}

  void join(Fragment &fragment);

private:
  /// A block that waits to be written, its pointers moved.
  struct Waiting {
    BlockRecord block;
    std::span<std::uint32_t> words;
    std::uint64_t place; ///< Where its new offset or number belongs.
    std::uint32_t hash;  ///< Of one that may be there already.
  };

  void put(std::span<std::uint32_t> words, const BlockRecord &block, std::uint64_t place);
  void writeWaiting();
  void fetchLeaves(const Fragment &fragment, std::size_t endBlock);
  Ref write(const Waiting &waiting);
  bool isIndexed(const BlockRecord &block) const;
  /// Where what a block becomes is kept: its new offset, or its number.
  std::uint32_t &newPlace(const BlockRecord &block, std::uint64_t place) {
    return (isIndexed(block) ? newNumbers_ : newOffsets_)[place];
  }
  void relocateResult(Fragment &fragment, std::size_t index);

  const Layout &layout_;
  const Ref placeMask_ = layout_.placeMask();
  NodeStore &store_;
  std::vector<std::uint32_t> newOffsets_;
  std::vector<std::uint32_t> newNumbers_; ///< Of indexed sub-volumes.
  std::vector<Waiting> waiting_;
  struct {
    std::size_t block = 0;
    std::uint64_t at = 1; ///< Of its words.
  } ahead_;               ///< Up to where leaves were fetched.
};

} // namespace voxc
