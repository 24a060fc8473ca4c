// Colours of pictures, in linear steps between 0 and 1.
#pragma once

#include <cmath>
#include <cstdint>

namespace voxc {

struct Colour {
  float red = 0;
  float green = 0;
  float blue = 0;

  friend Colour operator*(Colour c, float s) { return {c.red * s, c.green * s, c.blue * s}; }
  friend Colour operator+(Colour a, Colour b) { return {a.red + b.red, a.green + b.green, a.blue + b.blue}; }
};

/// From `a` at 0 to `b` at 1.
inline Colour mix(Colour a, Colour b, float amount) { return a * (1 - amount) + b * amount; }

/// A voxel's word as a colour; its alpha is left out.
inline Colour unpackColour(std::uint32_t word) {
  return Colour{float(word & 0xff), float(word >> 8 & 0xff), float(word >> 16 & 0xff)} * (1.0f / 255);
}

/// The opaque pixel of a colour with channels in [0, 1].
inline std::uint32_t packColour(Colour c) {
  auto channel = [](float value) { return static_cast<std::uint32_t>(std::lround(value * 255)); };
  return channel(c.red) | channel(c.green) << 8 | channel(c.blue) << 16 | 0xff000000u;
}

} // namespace voxc
