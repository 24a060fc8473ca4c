// Which texel a texture shows at a point.
#pragma once

#include "voxc/Mesh/TriangleScene.h"

#include <array>
#include <cstdint>

namespace voxc {

/// What is left of a number above the integer below. Numbers so large that they are integers, and what is no
/// number, leave nothing.
double fractionOf(double value);

/// Texture coordinates as a use of the texture maps them: 0 to 1 is the whole texture.
std::array<double, 2> mappedUv(const TextureUse &use, const std::array<double, 2> &uv);

/// The index of the texel at mapped coordinates, wrapped; of what is not a number, in the first column or
/// row.
std::uint64_t texelAt(const Texture &texture, const TextureUse &use, const std::array<double, 2> &mapped);

} // namespace voxc
