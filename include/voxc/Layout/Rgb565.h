// Colours of 5, 6 and 5 bits.
#pragma once

#include <cstdint>

namespace voxc {

/// The value that blocks keep of a colour: the nearest of 5 bits of R in the lowest byte, 6 of G and 5 of B
/// in the next ones. Alpha is left out.
constexpr std::uint32_t toRgb565(std::uint32_t word) {
  const auto nearest = [word](int shift, std::uint32_t most) {
    return ((word >> shift & 255) * most + 127) / 255;
  };
  return nearest(0, 31) | nearest(8, 63) << 8 | nearest(16, 31) << 16;
}

/// The opaque colour of such a value: its highest bits come again below.
constexpr std::uint32_t ofRgb565(std::uint32_t value) {
  const std::uint32_t r = value & 31;
  const std::uint32_t g = value >> 8 & 63;
  const std::uint32_t b = value >> 16 & 31;
  return (r << 3 | r >> 2) | (g << 2 | g >> 4) << 8 | (b << 3 | b >> 2) << 16 | 0xff000000u;
}

} // namespace voxc
