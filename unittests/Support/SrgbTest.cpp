// Bytes in sRGB and linear light.
#include "Support/Srgb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace voxc {
namespace {

/// The definition, by the mathematical library.
double lightOf(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

TEST(Srgb, LightIsThatOfTheDefinition) {
  for (int byte = 0; byte < 256; ++byte)
    EXPECT_NEAR(kLinearLight[static_cast<std::size_t>(byte)], lightOf(byte / 255.0), 1e-15) << byte;
}

TEST(Srgb, BytesAreTheNearest) {
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    EXPECT_EQ(srgbByte(kLinearLight[byte]), byte);
    const double border = lightOf((byte + 0.5) / 255);
    EXPECT_EQ(srgbByte(border * (1 - 1e-12)), byte);
    EXPECT_EQ(srgbByte(border * (1 + 1e-12)), std::min(byte + 1, 255u));
  }
}

TEST(Srgb, WhatIsOutsideIsTheEnd) {
  EXPECT_EQ(srgbByte(-1), 0u);
  EXPECT_EQ(srgbByte(std::numeric_limits<double>::quiet_NaN()), 0u);
  EXPECT_EQ(srgbByte(7), 255u);
  EXPECT_EQ(srgbByte(std::numeric_limits<double>::infinity()), 255u);
}

} // namespace
} // namespace voxc
