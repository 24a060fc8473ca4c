// Cubes of a finished volume as fragments: what building them apart would have given.
#pragma once

#include "Fragment.h"

#include "voxc/Layout/SlotKind.h"
#include "voxc/Layout/WordReader.h"

#include "Support/HashTable.h"

#include <cstdint>
#include <span>

namespace voxc {

/// Takes the words below one cube of a volume out of it, in the order in which construction writes them, each
/// block once. `Splice` is the inverse.
class Extraction {
public:
  /// False if a node says less of itself than what built it had to know, as one does that may be reflected:
  /// parts are then built anew.
  bool canTakeOut() const { return layout_.placeMask() == ~Ref{0}; }

  /// The words must have been checked; they and `layout` outlive this.
  Extraction(std::span<const std::uint32_t> words, const Layout &layout)
      : words_(layout.reader(words)), layout_(layout) {}

  /// The aligned cube of 2^log2Side voxels a side at `low`; log2Side is one of `Layout::partSide`. Its counts
  /// of shared blocks are 0: a volume does not tell how often a block was wanted.
  Fragment cube(Int3 low, int log2Side);

private:
  /// Where a block went, counted in words of the fragment, and the voxels below it.
  struct Placed {
    Ref at = 0;
    int layer = 0; ///< Of its tree, for which its voxels were counted.
    std::uint64_t voxels = 0;

    Placed inLayer(int other, int log2Shape) const;
  };

  /// The word at which a sub-volume begins, and the rank of its first voxel.
  struct Found {
    std::uint64_t at = 0;
    std::uint64_t rank = 0;
  };

  /// The word at which the array begins that the stratum's sub-volumes stand in.
  std::uint64_t arrayOf(const Stratum &stratum) const {
    return words_[static_cast<std::uint64_t>(stratum.arrayHead)];
  }
  Found subVolumeAround(std::size_t index, Int3 low) const;
  construct::Node partOfTree(std::size_t index, Found root, Int3 low, int log2Side);
  void partOfGrid(std::size_t index, Found root, Int3 low, int log2Side);
  void values(std::uint64_t rank, std::uint64_t count);

  Placed subVolume(std::size_t index, std::uint64_t at);
  Placed grid(std::size_t index, std::uint64_t at);
  Placed node(std::size_t index, std::uint64_t at, int layer);
  Placed record(std::size_t index, std::uint64_t at, const Placed &children);
  Placed cell(std::size_t index, std::uint32_t value);
  void leafWords(std::size_t index, std::uint64_t node);
  Ref block(std::size_t index, BlockRecord::Kind kind, Block what, std::uint64_t at, std::uint64_t count);

  WordReader words_;
  const Layout &layout_;
  Fragment *fragment_ = nullptr;
  HashTable<Placed> placed_; ///< By the word where a block stands in the volume.
};

} // namespace voxc
