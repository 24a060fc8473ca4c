// The order of a volume's axes: by what they mean, not by how a file happens to store them.
#pragma once

#include "Input/Dense/DenseVolume.h"

namespace voxc {

/// Turns, swaps and mirrors the axes of a volume so that each goes along the axis of the model that is
/// nearest to it, and the same way; `mirrorsX` has the first go the other way. Samples stay where they are in
/// the model. Equal scenes become equal voxels, whatever the order in which they are stored. A map that lets
/// two axes fall together is left alone.
void orient(DenseVolume &volume, bool mirrorsX = false);

} // namespace voxc
