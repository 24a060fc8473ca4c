// What a block of values holds, and the parts that blocks of every payload are put together from.
#pragma once

#include "voxc/Layout/ValueBlocks.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// Values in a block, but for the last one.
inline constexpr std::uint64_t kValueBlock = std::uint64_t{1} << kLog2ValueBlock;
/// Words of a bit for each of them.
inline constexpr std::uint64_t kRunWords = kValueBlock / 32;

/// What may be told in place of each value.
struct BlockContents {
  std::vector<std::uint32_t> runs;             ///< The value of each run,
  std::array<std::uint32_t, kRunWords> mask{}; ///< a bit for each value that begins one,
  std::vector<std::uint32_t> begins;           ///< and the numbers of those values.
  std::vector<std::uint32_t> palette;          ///< Each value once, in the order in which they come.

  /// Where a value of the block stands in the palette.
  std::uint32_t indexOf(std::uint32_t value) const;
};

/// Of 1 to 2^kLog2ValueBlock values.
BlockContents contentsOf(std::span<const std::uint32_t> values);

/// How many runs begin among the first `count` values of a block whose mask of them stands at `mask`.
std::uint64_t runsBegun(const WordReader &words, std::uint64_t mask, std::uint64_t count);

/// Appends fields of few bits to words.
class BitWriter {
public:
  explicit BitWriter(std::vector<std::uint32_t> &words) : words_(words) {}

  /// A field of at most 32 bits.
  void write(std::uint32_t field, int bits) {
    pending_ |= std::uint64_t{field} << count_;
    count_ += bits;
    if (count_ >= 32)
      flush();
  }
  /// Begins a new word.
  void align() {
    if (count_ > 0)
      flush();
    count_ = 0;
  }

private:
  void flush() {
    words_.push_back(static_cast<std::uint32_t>(pending_));
    pending_ >>= 32;
    count_ -= 32;
  }

  std::vector<std::uint32_t> &words_;
  std::uint64_t pending_ = 0;
  int count_ = 0;
};

} // namespace voxc
