// How many times as bright as its colour a light is, in the 24 bits of a word that has an alpha.
#pragma once

#include <bit>
#include <cstdint>

namespace voxc {

/// The word of a strength of 0 or more, opaque: the upper 24 bits of the float32, rounded, as R, G and B from
/// the low byte.
constexpr std::uint32_t strengthWord(float strength) {
  return ((std::bit_cast<std::uint32_t>(strength) + 0x80) >> 8 & 0xffffff) | 0xff000000;
}

/// The strength that a word encodes, whatever its alpha.
constexpr float strengthOfWord(std::uint32_t word) { return std::bit_cast<float>(word << 8); }

} // namespace voxc
