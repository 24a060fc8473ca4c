// Rules of one stratum.
#pragma once

#include "voxc/Layout/Stratum.h"

#include <string>

namespace voxc {

/// What is wrong with the words of one sub-volume, or "": one whose slots alone need more than references
/// reach cannot hold even one voxel.
std::string sizeProblem(const Stratum &stratum, int log2Granule);

} // namespace voxc
