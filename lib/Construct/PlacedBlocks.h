// Where the blocks of a volume went that are being copied: a table that is asked for every reference.
#pragma once

#include "voxc/Layout/Stratum.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace voxc {

/// Open addressing: a question costs one place in memory, where std::unordered_map costs three.
class PlacedBlocks {
public:
  /// Where a block went, counted in words of the fragment, and the voxels below it.
  struct Placed {
    Ref at = 0;
    int layer = 0; ///< Of its tree, for which its voxels were counted.
    std::uint64_t voxels = 0;
  };

  PlacedBlocks() { clear(); }

  /// Forgets all; what comes next may be about as much, and has room for it.
  void clear();
  /// That of the block at a word other than 0; null if it was not placed. Valid until the next `place`.
  const Placed *find(std::uint64_t word) const {
    const Entry &entry = entries_[slotOf(word)];
    return entry.word == word ? &entry.placed : nullptr;
  }
  void place(std::uint64_t word, const Placed &placed);

private:
  struct Entry {
    std::uint64_t word = 0; ///< 0: free. No block stands there.
    Placed placed;
  };

  /// Of the word, or the free one where it would go.
  std::size_t slotOf(std::uint64_t word) const {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;
    std::size_t slot = word * kGolden >> shift_;
    while (entries_[slot].word != word && entries_[slot].word != 0)
      slot = (slot + 1) & (entries_.size() - 1);
    return slot;
  }
  void grow();

  std::vector<Entry> entries_; ///< A power of two of them, at most two thirds in use.
  int shift_ = 0;
  std::size_t count_ = 0;
};

} // namespace voxc
