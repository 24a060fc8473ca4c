// Numbers of a PLY file as doubles, of which a colour that is packed into a float gets its bits back: those
// of many are no number, and a conversion would set one of them.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace voxc {

/// A number as a double; a NaN of a float keeps its sign and its fraction.
template <typename Stored> double widened(Stored stored) {
  if constexpr (std::is_same_v<Stored, float>)
    if (std::isnan(stored)) {
      const std::uint64_t bits = std::bit_cast<std::uint32_t>(stored);
      return std::bit_cast<double>((bits & 0x80000000) << 32 | 0x7ff0000000000000 | (bits & 0x7fffff) << 29);
    }
  return static_cast<double>(stored);
}

/// The bits of the float that `widened` made this of.
inline std::uint32_t narrowedBits(double value) {
  if (!std::isnan(value))
    return std::bit_cast<std::uint32_t>(static_cast<float>(value));
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return static_cast<std::uint32_t>((bits >> 32 & 0x80000000) | 0x7f800000 | (bits >> 29 & 0x7fffff));
}

} // namespace voxc
