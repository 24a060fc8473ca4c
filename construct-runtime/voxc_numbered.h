// voxc_numbered.h: masked grids with numbers of sub-volumes in place of references, of few bits each.
#pragma once

#include "voxc_masked.h"

namespace voxc::construct {

template <typename Level> struct NumberedWriting {
  /// For a grid that is being filled, and for the same once more, shortened.
  static constexpr uint64_t kRoom = 2 * FilledGrid<Level>::kWords;

  /// Writes a filled grid with numbers in place of slots. Returns what leads to it.
  static uint32_t write(Build &build, uint32_t *grid) {
    uint32_t *const shortened = grid + FilledGrid<Level>::kWords;
    const uint64_t words = shorten(grid, MaskPacking<Level>::pack(build, grid), shortened);
    return put_words<Level>(build, shortened, words);
  }

private:
  static constexpr uint64_t kHead = FilledGrid<Level>::kHead;

  /// Shortens the slots of a packed grid of so many words: first the numbers of all sub-volumes, then what
  /// stood behind them, or behind the first of each octant of cells but the first, which has the least.
  /// Returns how many words that takes.
  static uint64_t shorten(const uint32_t *grid, uint64_t words, uint32_t *shortened) {
    const uint64_t slots = (words - kHead) / Level::SLOT_WORDS;
    const uint64_t numbers = slots * Level::POINTER_BITS; // Bits of them.
    for (uint64_t i = 0; i < kHead; ++i)
      shortened[i] = grid[i];
    for (uint64_t i = 0; i < slots; ++i) {
      const uint32_t *const slot = grid + kHead + Level::SLOT_WORDS * i;
      put_bits(shortened + kHead, i * Level::POINTER_BITS, Level::POINTER_BITS, slot[0]);
      if constexpr (Level::RANKED && !Level::OCTANT_COUNTS)
        put_bits(shortened + kHead, numbers + i * Level::COUNT_BITS, Level::COUNT_BITS, slot[1]);
    }
    uint64_t end = numbers + slots * Level::COUNT_BITS;
    if constexpr (Level::OCTANT_COUNTS)
      end = count_octants(grid, numbers, shortened);
    return kHead + (end + 31) / 32;
  }

  /// Writes the counts of octants from a bit on; returns where they end.
  static uint64_t count_octants(const uint32_t *grid, uint64_t end, uint32_t *shortened) {
    // Bits and slots have one order, in which the first cell of an octant need not come first.
    constexpr uint32_t kNone = 0xffffffff;
    uint32_t least[8] = {kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
    const uint32_t *slot = grid + kHead;
    for (unsigned cell = 0; cell < 64; ++cell) {
      if ((grid[cell / 32] >> cell % 32 & 1) == 0)
        continue;
      uint32_t &before = least[(cell >> 1 & 1) | (cell >> 2 & 2) | (cell >> 3 & 4)];
      before = slot[1] < before ? slot[1] : before;
      slot += Level::SLOT_WORDS;
    }
    for (const uint32_t before : least)
      if (before != kNone && before != 0) { // Before the first are none.
        put_bits(shortened + kHead, end, Level::COUNT_BITS, before);
        end += Level::COUNT_BITS;
      }
    return end;
  }
};

} // namespace voxc::construct
