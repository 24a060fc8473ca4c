// What the colours of voxels are: counts, spread, and how many there are near each other.
#pragma once

#include "Brick.h"
#include "DistinctSet.h"
#include "WordTally.h"

#include "voxc/Facts/Facts.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace voxc {

/// The mean number of different words in blocks of at most `kWords` words.
template <unsigned kWords> class LocalColours {
public:
  /// Begins a block; needed before the first word.
  void start() { ++blocks_; }

  void add(std::uint32_t word) {
    // Half full at most; a slot with another block's number is free.
    unsigned at = word * 0x9e3779b1u >> (32 - kLog2Slots);
    while (slots_[at].block == blocks_ && slots_[at].word != word)
      at = (at + 1) % kSlots;
    different_ += slots_[at].block != blocks_;
    slots_[at] = {blocks_, word};
  }

  double mean() const {
    return blocks_ == 0 ? 0 : static_cast<double>(different_) / static_cast<double>(blocks_);
  }

private:
  static constexpr int kLog2Slots = std::bit_width(kWords);
  static constexpr unsigned kSlots = 1u << kLog2Slots;

  struct Slot {
    std::uint64_t block = 0;
    std::uint32_t word = 0;
  };

  std::array<Slot, kSlots> slots_{};
  std::uint64_t blocks_ = 0;
  std::uint64_t different_ = 0;
};

class ColourTally {
public:
  /// Counts `mostWords` different words one by one at most.
  explicit ColourTally(std::size_t mostWords);

  /// Takes the next brick, in Morton order, that is not empty.
  void add(const Brick &brick);
  /// Ends the adding.
  ColourFacts finish();

private:
  static constexpr std::uint64_t kRun = 256;

  void add(std::uint32_t word, bool isFirst);
  void endRepeats();

  std::uint64_t voxels_ = 0;
  std::uint32_t last_ = 0;     ///< The word of the voxel before.
  std::uint64_t repeated_ = 0; ///< Voxels of that word up to there.
  std::uint64_t changes_ = 0;  ///< Voxels whose word was not that of the voxel before.

  WordTally counts_;
  DistinctSet words_;
  DistinctSet rgb_;
  std::array<std::array<std::uint64_t, 256>, 4> histograms_{};
  LocalColours<64> inBlock4_;
  LocalColours<512> inBlock8_;
  LocalColours<kRun> inRun_;
};

} // namespace voxc
