// A bit for each cell of a brick of 8^3, in the two orders in which bricks are read and searched.
#pragma once

#include "voxc/Support/Geometry.h"

#include <array>
#include <bit>
#include <cstdint>

namespace voxc {

/// 8^3 bits by coordinates: that of (x, y, z) is bit x + 8 * y of slice z.
using Slices = std::array<std::uint64_t, 8>;

/// 8^3 bits in Morton order: the i-th is bit i % 64 of word i / 64.
using MortonBits = std::array<std::uint64_t, 8>;

/// Which of 512 words in Morton order are not 0.
MortonBits bitsOf(const std::uint32_t *words);

Slices toSlices(const MortonBits &bits);
MortonBits toMorton(const Slices &slices);

/// The cells of a brick that lie in a box, both ends given from the brick's low corner.
Slices cellsBetween(Int3 low, Int3 high);

inline bool isAny(const Slices &slices) {
  std::uint64_t any = 0;
  for (const std::uint64_t slice : slices)
    any |= slice;
  return any != 0;
}

inline std::uint64_t countBits(const Slices &slices) {
  std::uint64_t count = 0;
  for (const std::uint64_t slice : slices)
    count += static_cast<std::uint64_t>(std::popcount(slice));
  return count;
}

inline constexpr std::uint64_t kColumnBits = 0x0101010101010101; ///< The bits with x = 0 of a slice.
inline constexpr std::uint64_t kRowBits = 0xff;                  ///< The bits with y = 0.

/// All bits one cell along an axis, up (`step` 1) or down (-1); what leaves the brick is gone.
inline Slices shifted(const Slices &s, int axis, int step) {
  Slices moved{};
  if (axis == 2) {
    for (unsigned z = 0; z < 7; ++z)
      moved[step > 0 ? z + 1 : z] = s[step > 0 ? z : z + 1];
    return moved;
  }
  const unsigned shift = axis == 0 ? 1 : 8;
  const std::uint64_t first = axis == 0 ? kColumnBits : kRowBits;
  const std::uint64_t last = first << 7 * shift;
  for (unsigned z = 0; z < 8; ++z)
    moved[z] = step > 0 ? s[z] << shift & ~first : s[z] >> shift & ~last;
  return moved;
}

/// The bits that leave the brick in such a step, where they come into the next one.
inline Slices carried(const Slices &s, int axis, int step) {
  Slices moved{};
  if (axis == 2) {
    moved[step > 0 ? 0 : 7] = s[step > 0 ? 7 : 0];
    return moved;
  }
  const unsigned shift = axis == 0 ? 7 : 56;
  const std::uint64_t first = axis == 0 ? kColumnBits : kRowBits;
  for (unsigned z = 0; z < 8; ++z)
    moved[z] = step > 0 ? s[z] >> shift & first : (s[z] & first) << shift;
  return moved;
}

} // namespace voxc
