// Between bytes in sRGB and linear light. By tables, so that every machine gives the same.
#pragma once

#include <array>
#include <cstdint>

namespace voxc {

/// The linear light, 0 to 1, that each byte in sRGB stands for.
extern const std::array<double, 256> kLinearLight;

/// The byte in sRGB that stands for linear light, the nearest one in sRGB: 0 below 0 and of what is no
/// number, 255 above 1.
std::uint32_t srgbByte(double light);

} // namespace voxc
