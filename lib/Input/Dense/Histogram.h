// How often the samples of a dense volume have which value, and where their background ends.
#pragma once

#include "Input/Dense/DenseVolume.h"

#include <array>
#include <cstdint>

namespace voxc {

/// Counts of samples: those that are 0, those that are `isNothing`, and the others by 256 equal parts of
/// their range, of which the last has infinity too.
struct Histogram {
  SampleRange range; ///< Of the values; 0 to 0 if none is finite.
  std::array<std::uint64_t, 256> counts{};
  std::uint64_t zeros = 0;
  std::uint64_t noNumbers = 0;

  std::uint64_t total() const; ///< All samples.
  double width() const;        ///< Of a part of the range.
  /// The share of the samples, 0 to 1, that are `threshold` or more, but not 0.
  double shareFrom(double threshold) const;
  /// The value that parts the samples best in two: that of the greatest variance between both parts (N. Otsu,
  /// "A threshold selection method from gray-level histograms", 1979).
  double threshold() const;
};

/// Counts all samples of values in `range`. Error: interrupted.
Expected<Histogram> histogramOf(const DenseVolume &volume, const SampleMap &map, const SampleRange &range,
                                const InputOptions &options);

} // namespace voxc
