// What a dense volume says of itself: its samples, their spacing and range, and how often they have which
// value.
#pragma once

#include "Input/Dense/DenseVolume.h"
#include "Input/Dense/Histogram.h"

namespace voxc {

/// All facts of a volume whose samples were counted by `histogram`.
std::vector<InputFact> factsOf(const DenseVolume &volume, const Histogram &histogram);

/// Those of a volume of colours.
std::vector<InputFact> factsOf(const DenseVolume &volume);

} // namespace voxc
