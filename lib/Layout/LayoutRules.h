// Rules of one stratum.
#pragma once

#include "voxc/Layout/Layout.h"

#include <string>

namespace voxc {

/// What is wrong with the words of one sub-volume, or "": one whose slots alone need more than references
/// reach cannot hold even one voxel.
std::string sizeProblem(const Layout &layout, const Stratum &stratum);

/// Why references to nodes of the stratum cannot count the layout's granules, or "".
std::string granuleProblem(const Layout &layout, const Stratum &stratum);

} // namespace voxc
