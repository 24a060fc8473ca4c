// Value noise and the arithmetic of ranges.
#include "Source/Builtin/Noise.h"

#include "Source/Builtin/Scenes.h"

#include <algorithm>

namespace voxc {

namespace {

/// Bends t so that neighbouring squares meet without a crease.
std::int64_t smooth(std::int64_t t) { return t * t * (3 * kOne - 2 * t) >> 32; }

std::int64_t blend(std::int64_t a, std::int64_t b, std::int64_t t) { return a + ((b - a) * t >> 16); }

} // namespace

Range multiply(Range a, Range b) { return {a.low * b.low >> 16, a.high * b.high >> 16}; }

Range ramp(Range value, std::int64_t from, std::int64_t to) {
  const auto at = [&](std::int64_t v) {
    return std::clamp<std::int64_t>((v - from) * kOne / (to - from), 0, kOne);
  };
  return {at(value.low), at(value.high)};
}

Range ridge(Range value) {
  const auto at = [](std::int64_t v) { return std::min(2 * v, 2 * (kOne - v)); };
  const bool holdsTop = value.low <= kOne / 2 && value.high >= kOne / 2;
  return {std::min(at(value.low), at(value.high)), holdsTop ? kOne : std::max(at(value.low), at(value.high))};
}

std::int64_t Noise::corner(std::int32_t x, std::int32_t z) const { return hashCell({x, z, 0}, seed_) >> 16; }

std::int64_t Noise::at(std::int32_t x, std::int32_t z) const {
  const std::int32_t squareX = x >> log2Square_;
  const std::int32_t squareZ = z >> log2Square_;
  const auto within = [&](std::int32_t coordinate, std::int32_t square) {
    return smooth((std::int64_t{coordinate} - (std::int64_t{square} << log2Square_)) * kOne >> log2Square_);
  };
  const std::int64_t alongX = within(x, squareX);
  const std::int64_t near = blend(corner(squareX, squareZ), corner(squareX + 1, squareZ), alongX);
  const std::int64_t far = blend(corner(squareX, squareZ + 1), corner(squareX + 1, squareZ + 1), alongX);
  return blend(near, far, within(z, squareZ));
}

Range Noise::over(const Rectangle &area) const {
  if (area.lowX == area.highX && area.lowZ == area.highZ) {
    const std::int64_t value = at(area.lowX, area.lowZ);
    return {value, value};
  }
  // Along each axis the noise is monotone within a square, so the extremes lie on the corners of the
  // rectangle and where it crosses the lattice. Over several squares anything may happen.
  if ((area.highX >> log2Square_) - (area.lowX >> log2Square_) > 1 ||
      (area.highZ >> log2Square_) - (area.lowZ >> log2Square_) > 1)
    return {0, kOne};
  const std::int32_t x[3] = {area.lowX, area.highX,
                             std::max(area.lowX, area.highX >> log2Square_ << log2Square_)};
  const std::int32_t z[3] = {area.lowZ, area.highZ,
                             std::max(area.lowZ, area.highZ >> log2Square_ << log2Square_)};
  Range range{kOne, 0};
  for (const std::int32_t px : x)
    for (const std::int32_t pz : z) {
      const std::int64_t value = at(px, pz);
      range = {std::min(range.low, value), std::max(range.high, value)};
    }
  // Each of the three blends rounds down by less than one.
  constexpr std::int64_t kRounding = 3;
  return {std::max<std::int64_t>(range.low - kRounding, 0), std::min(range.high + kRounding, kOne)};
}

} // namespace voxc
