// What construction and edits of a level have in common: its constants, and how a leaf of construct-runtime
// is filled for it.
#pragma once

#include "voxc/Plan/Plan.h"

#include <cstddef>
#include <string>

namespace voxc {

/// "constexpr int LEVEL_2_LAYERS = 8;" and so on.
std::string constructConstants(const Plan &plan, std::size_t index);

/// A file of construct-runtime, named without its ending, for a level, after an empty line.
std::string constructLeaf(const Plan &plan, std::size_t index, const std::string &file);

/// What all levels that measure distances share; "" if none does.
std::string constructPlanes(const Plan &plan);

} // namespace voxc
