// Mapping and wrapping of texture coordinates.
#include "Mesh/Voxelize/TexelPlace.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace voxc {

namespace {

double repeated(double coordinate) { return fractionOf(coordinate); }

double mirrored(double coordinate) {
  const double fraction = 2 * fractionOf(coordinate / 2);
  return fraction > 1 ? 2 - fraction : fraction;
}

double clamped(double coordinate) { return coordinate; }

/// Where a coordinate falls in the texture, which reaches from 0 to 1; in the order of `TextureWrap`.
constexpr std::array<double (*)(double), 3> kWraps{repeated, mirrored, clamped};

/// The texel column or row of a coordinate; the first of one that is not a number.
int texelIndex(double coordinate, TextureWrap wrap, int size) {
  // Most textures repeat: no call for them.
  const double place =
      wrap == TextureWrap::Repeat ? repeated(coordinate) : kWraps[static_cast<std::size_t>(wrap)](coordinate);
  return place > 0 ? static_cast<int>(std::min<double>(place * size, size - 1)) : 0;
}

} // namespace

/// (`std::floor` is a call on processors that may lack the instruction.)
double fractionOf(double value) {
  if (!(std::abs(value) < 0x1p52))
    return 0;
  const double cut = value - static_cast<double>(static_cast<std::int64_t>(value));
  return cut < 0 ? cut + 1 : cut;
}

std::array<double, 2> mappedUv(const TextureUse &use, const std::array<double, 2> &uv) {
  const std::array<float, 6> &m = use.matrix;
  return {m[0] * uv[0] + m[1] * uv[1] + m[2], m[3] * uv[0] + m[4] * uv[1] + m[5]};
}

UvEnds::UvEnds(const TextureUse &use, const std::array<std::array<double, 2>, 3> &corners) {
  low_ = high_ = mappedUv(use, corners[0]);
  for (const std::array<double, 2> &corner : std::span(corners).last(2))
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double place = mappedUv(use, corner)[axis];
      low_[axis] = std::min(low_[axis], place);
      high_[axis] = std::max(high_[axis], place);
    }
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (low_[axis] < high_[axis])
      high_[axis] = std::nextafter(high_[axis], low_[axis]);
}

std::array<double, 2> UvEnds::within(const std::array<double, 2> &mapped) const {
  // In this order what is no number stays so.
  return {std::max(std::min(mapped[0], high_[0]), low_[0]), std::max(std::min(mapped[1], high_[1]), low_[1])};
}

std::uint64_t texelAt(const Texture &texture, const TextureUse &use, const std::array<double, 2> &mapped) {
  const auto x = static_cast<std::uint64_t>(texelIndex(mapped[0], use.wrap[0], texture.width));
  const auto y = static_cast<std::uint64_t>(texelIndex(mapped[1], use.wrap[1], texture.height));
  return y * static_cast<std::uint64_t>(texture.width) + x;
}

} // namespace voxc
