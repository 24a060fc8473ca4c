// Whether the samples of a volume are numbers of things, such as the parts of a segmentation.
#pragma once

#include "Input/Dense/DenseVolume.h"

#include <cstddef>
#include <optional>

namespace voxc {

/// How many different labels other than 0 a volume has, if its samples look like labels: whole numbers,
/// either few different ones, or such that neighbours are mostly equal, as no measured values are. Nothing if
/// they do not. Error: interrupted.
Expected<std::optional<std::size_t>> countLabels(const DenseVolume &volume, const InputOptions &options);

} // namespace voxc
