// How many bits number the grids of 4 x 4 x 4 voxels that short pointers lead to.
#pragma once

#include "voxc/Facts/Facts.h"

#include <optional>

namespace voxc {

/// The fewest bits of short pointers, 8 to 24, that number all shapes of blocks of 4^3; no value if 24 are
/// too few. Where shapes were estimated, they are taken to be a twentieth more than that.
std::optional<int> choosePointerBits(const Facts &facts);

} // namespace voxc
