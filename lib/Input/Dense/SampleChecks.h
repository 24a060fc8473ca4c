// What is said of samples in sentences: of a threshold that parts nothing, and of what does not fit into a
// word.
#pragma once

#include "Input/Dense/Samples.h"
#include "voxc/Support/Error.h"

#include <optional>
#include <string>

namespace voxc {

/// Error: the threshold is no number.
Expected<void> checkThreshold(const std::optional<double> &threshold);

/// A sentence with the range of the samples, if all of them reach the threshold or none does; else nothing.
std::optional<std::string> complaintOf(double threshold, const SampleRange &range);

/// Error: samples of this range are kept as whole numbers, and do not fit into 4 bytes.
Expected<void> checkKept(SampleMap::Kept kept, const SampleRange &range);

} // namespace voxc
