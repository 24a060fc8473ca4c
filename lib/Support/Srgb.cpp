// The tables, made by the compiler from the definition in IEC 61966-2-1.
#include "Support/Srgb.h"

#include <algorithm>

namespace voxc {

namespace {

/// By Newton's way, from above; of 0 to 1.
constexpr double fifthRoot(double value) {
  double root = 1;
  for (int i = 0; i < 60; ++i) {
    const double fourth = root * root * root * root;
    root -= (root * fourth - value) / (5 * fourth);
  }
  return root;
}

/// Of a value in sRGB, 0 to 1. The exponent is 2.4, which is 2 and 2 fifths.
constexpr double linearOf(double value) {
  if (value <= 0.04045)
    return value / 12.92;
  const double base = (value + 0.055) / 1.055;
  return base * base * fifthRoot(base * base);
}

/// Light halfway, in sRGB, between each byte and the next; then what no light reaches.
constexpr std::array<double, 256> kBorders = [] {
  std::array<double, 256> borders{};
  for (std::size_t byte = 0; byte < 255; ++byte)
    borders[byte] = linearOf((static_cast<double>(byte) + 0.5) / 255);
  borders[255] = 2;
  return borders;
}();

constexpr std::size_t kSteps = 4096;

/// The byte at the low end of each of so many steps of light, from which the right one is not far.
constexpr std::array<std::uint8_t, kSteps> kFirst = [] {
  std::array<std::uint8_t, kSteps> first{};
  std::uint8_t byte = 0;
  for (std::size_t step = 0; step < kSteps; ++step) {
    while (kBorders[byte] <= static_cast<double>(step) / kSteps)
      ++byte;
    first[step] = byte;
  }
  return first;
}();

} // namespace

constexpr std::array<double, 256> kLinearLight = [] {
  std::array<double, 256> light{};
  for (std::size_t byte = 0; byte < light.size(); ++byte)
    light[byte] = linearOf(static_cast<double>(byte) / 255);
  return light;
}();

std::uint32_t srgbByte(double light) {
  if (!(light > 0))
    return 0;
  const double most = std::min(light, 1.0);
  std::uint32_t byte = kFirst[std::min(static_cast<std::size_t>(most * kSteps), kSteps - 1)];
  while (kBorders[byte] <= most)
    ++byte;
  return byte;
}

} // namespace voxc
