// Exact differences and products of doubles, as sums of two: the middle way between one double and wide
// integers.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>

namespace voxc {

/// The exact number high + low, where high is that number rounded to double.
struct DoublePair {
  double high;
  double low;
};

/// a - b, if it is a double. Neither may be so large that the difference overflows.
inline std::optional<double> exactDifference(double a, double b) {
  const double difference = a - b;
  const double partOfB = a - difference;
  const double error = (a - (difference + partOfB)) + (partOfB - b);
  return error == 0 ? std::optional(difference) : std::nullopt;
}

/// wide * narrow, where `narrow` is a float32 and neither overflow nor underflow is near.
inline DoublePair exactProduct(double wide, double narrow) {
  // 29 bits times 24, and what is left of 53, 24 bits, times 24: both products are exact.
  const auto top = std::bit_cast<double>(std::bit_cast<std::uint64_t>(wide) & ~std::uint64_t{0xffffff});
  const double large = top * narrow, small = (wide - top) * narrow;
  const double sum = large + small;
  return {sum, small - (sum - large)};
}

/// Below 0, 0 or above 0, as a is less than, equal to or greater than b.
inline int order(const DoublePair &a, const DoublePair &b) {
  // Rounding is monotonic: where the high parts differ they decide.
  const double left = a.high == b.high ? a.low : a.high;
  const double right = a.high == b.high ? b.low : b.high;
  return left < right ? -1 : left > right ? 1 : 0;
}

} // namespace voxc
