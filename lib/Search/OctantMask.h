// Counting octants in a mask of eight bits, quickly also where the processor's own instruction may not be
// used.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace voxc {

inline constexpr std::array<std::uint8_t, 256> kOctantCounts = [] {
  std::array<std::uint8_t, 256> counts{};
  for (unsigned mask = 0; mask < counts.size(); ++mask)
    counts[mask] = static_cast<std::uint8_t>(std::popcount(mask));
  return counts;
}();

/// How many octants there are.
inline std::size_t octantsIn(std::uint32_t mask) { return kOctantCounts[mask & 255]; }

/// How many there are before one of them.
inline std::size_t octantsBefore(std::uint32_t mask, unsigned octant) {
  return octantsIn(mask & ((1u << octant) - 1));
}

} // namespace voxc
