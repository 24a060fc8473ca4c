// Checks of samples, and their sentences.
#include "Input/Dense/SampleChecks.h"

#include "Input/Openers/InputText.h"

#include <cmath>

namespace voxc {

Expected<void> checkThreshold(const std::optional<double> &threshold) {
  if (threshold && std::isnan(*threshold))
    return Error::usage("a threshold is a number from which on samples are voxels, and nan is none");
  return {};
}

std::optional<std::string> complaintOf(double threshold, const SampleRange &range) {
  const std::string samples = "they are from " + toText(range.low) + " to " + toText(range.high);
  if (threshold > range.high)
    return "no sample reaches the threshold " + toText(threshold) + "; " + samples;
  if (threshold <= range.low && range.low < range.high)
    return "no sample is below the threshold " + toText(threshold) + ", which leaves none out; " + samples;
  return std::nullopt;
}

Expected<void> checkKept(SampleMap::Kept kept, const SampleRange &range) {
  constexpr double kMost = 2147483648.0;
  if (kept == SampleMap::Kept::Int32 && (range.low < -kMost || range.high >= kMost))
    return Error::input("its samples are from " + toText(range.low) + " to " + toText(range.high) +
                        ", and 4 bytes hold whole numbers from -2147483648 to 2147483647");
  return {};
}

} // namespace voxc
