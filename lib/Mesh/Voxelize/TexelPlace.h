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

/// Where the mapped coordinates of a triangle end. A point on its upper end shows what those inside it do: at
/// 1 the last texel, though a texture that repeats begins anew there.
class UvEnds {
public:
  UvEnds(const TextureUse &use, const std::array<std::array<double, 2>, 3> &corners);

  /// Mapped coordinates of a point of the triangle, without what rounding put beyond it.
  std::array<double, 2> within(const std::array<double, 2> &mapped) const;

private:
  std::array<double, 2> low_, high_;
};

/// The index of the texel at mapped coordinates, wrapped; of what is not a number, in the first column or
/// row.
std::uint64_t texelAt(const Texture &texture, const TextureUse &use, const std::array<double, 2> &mapped);

} // namespace voxc
