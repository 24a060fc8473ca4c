// Voxels whose faces are merged only where their colours and looks are the same.
#pragma once

#include "Source/Export/VoxelLooks.h"
#include "voxc/Source/VoxelSource.h"

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace voxc {

/// Numbers for the pairs of words and looks that occur.
class LookedVoxels {
public:
  struct Pair {
    std::uint32_t word = 0;
    std::uint32_t look = 0; ///< A number in `VoxelLooks::all()`.

    auto operator<=>(const Pair &) const = default;
  };

  /// Both must outlive this and its sources.
  LookedVoxels(const Volume &volume, const VoxelLooks &looks) : volume_(volume), looks_(looks) {}

  /// The voxels, with the numbers of pairs in place of words, or, where nothing is said of any, words.
  std::unique_ptr<VoxelSource> source();
  /// What a word that the source gave stands for.
  Pair pair(std::uint32_t word) const { return looks_.areAny() ? pairs_[word - 1] : Pair{word, 0}; }

private:
  class Source;

  std::uint32_t numberOf(const Pair &pair);

  const Volume &volume_;
  const VoxelLooks &looks_;
  std::vector<Pair> pairs_; ///< By their numbers, from 1.
  std::map<Pair, std::uint32_t> numbers_;
};

} // namespace voxc
