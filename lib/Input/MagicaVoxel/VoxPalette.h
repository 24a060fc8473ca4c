// The colours of MagicaVoxel files that bring none.
#pragma once

#include <array>
#include <cstdint>

namespace voxc {

/// By number: 1 to 215 are a cube of six steps a channel from white down, blue fastest, without black; then
/// ten shades each of red, green, blue and grey.
constexpr std::array<std::uint32_t, 256> defaultVoxPalette() {
  std::array<std::uint32_t, 256> colours{};
  const auto colour = [](std::uint32_t r, std::uint32_t g, std::uint32_t b) {
    return r | g << 8 | b << 16 | 0xff000000u;
  };
  constexpr std::uint32_t kStep = 0x33;
  for (std::uint32_t i = 0; i < 215; ++i)
    colours[1 + i] = colour((5 - i / 36) * kStep, (5 - i / 6 % 6) * kStep, (5 - i % 6) * kStep);
  // The multiples of 0x11 that the cube does not have.
  constexpr std::array<std::uint32_t, 10> kShades{14, 13, 11, 10, 8, 7, 5, 4, 2, 1};
  for (std::uint32_t i = 0; i < 10; ++i) {
    const std::uint32_t shade = kShades[i] * 0x11;
    colours[216 + i] = colour(shade, 0, 0);
    colours[226 + i] = colour(0, shade, 0);
    colours[236 + i] = colour(0, 0, shade);
    colours[246 + i] = colour(shade, shade, shade);
  }
  return colours;
}

} // namespace voxc
