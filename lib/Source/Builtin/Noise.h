// Noise in integers over the plane, with bounds over rectangles: what the terrain is made of.
#pragma once

#include <cstdint>

namespace voxc {

/// One, in the fixed-point numbers of the noise.
inline constexpr std::int64_t kOne = 1 << 16;

/// Every value from `low` to `high`. Arithmetic on ranges holds for all values in them.
struct Range {
  std::int64_t low;
  std::int64_t high;

  friend Range operator+(Range a, Range b) { return {a.low + b.low, a.high + b.high}; }
};

/// The product of two ranges of numbers that are not negative, in fixed point.
Range multiply(Range a, Range b);
/// Rises from 0 at `from` to kOne at `to`, and is flat outside.
Range ramp(Range value, std::int64_t from, std::int64_t to);
/// A ridge: kOne where the value is one half, falling to 0 at 0 and kOne.
Range ridge(Range value);

/// Integer points of the plane, both corners included.
struct Rectangle {
  std::int32_t lowX;
  std::int32_t lowZ;
  std::int32_t highX;
  std::int32_t highZ;
};

/// Smooth noise from 0 to kOne: random values at the corners of a square lattice, blended between them.
class Noise {
public:
  /// Squares of 2^log2Square points a side.
  Noise(int log2Square, std::uint32_t seed) : log2Square_(log2Square), seed_(seed) {}

  /// Bounds over a rectangle; of a single point, its exact value.
  Range over(const Rectangle &area) const;

private:
  std::int64_t corner(std::int32_t x, std::int32_t z) const;
  std::int64_t at(std::int32_t x, std::int32_t z) const;

  int log2Square_;
  std::uint32_t seed_;
};

} // namespace voxc
