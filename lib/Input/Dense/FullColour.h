// What the brightest number of colours is, where their type says too little.
#pragma once

#include "Input/Dense/DenseVolume.h"

namespace voxc {

/// Finds `fullColour` and `fullAlpha` of a volume of colours, and warns of what was guessed, or of what stays
/// nearly black. They are the greatest number of the type, or 1 of floats. Of wider types than a byte,
/// numbers up to 255 are taken as bytes, those of more than 16 bits up to 65535 as of 16, and alpha of 0 and
/// 1 as a share. Error: interrupted.
Expected<void> findFullColour(DenseVolume &volume, const InputOptions &options);

} // namespace voxc
