// To what the numbers of a file's colours count.
#pragma once

#include <algorithm>
#include <cmath>

namespace voxc {

/// Looks at all numbers of a file's colours. Formats mean fractions from 0 to 1, and many files have whole
/// numbers to 255 all the same.
class ColourScale {
public:
  void add(double channel) {
    if (!std::isfinite(channel))
      return;
    largest_ = std::max(largest_, channel);
    areWhole_ = areWhole_ && channel == std::floor(channel);
  }

  double largest() const { return largest_; }

  /// What stands for the brightest: 1, 255, 65535 or 2^32 - 1. Fractions up to 2 are light that is too
  /// bright.
  double whole() const {
    if (largest_ <= (areWhole_ ? 1 : 2))
      return 1;
    return wholeOfIntegers();
  }

  /// The same for integers, of which 1 is nearly black.
  double wholeOfIntegers() const {
    if (largest_ <= 255)
      return 255;
    return largest_ <= 65535 ? 65535 : 4294967295.0;
  }

private:
  double largest_ = 0;
  bool areWhole_ = true;
};

} // namespace voxc
