// Names and numbers that emitted text has in several places.
#pragma once

#include "voxc/Plan/Plan.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace voxc {

/// The layers of nodes in the strata before one, as the path of a flat traversal has them: one of a grid and
/// of a single cell.
int firstLayer(const Layout &layout, std::size_t index);

/// The words of a node or a grid before those of its slots.
std::uint32_t headWords(const Stratum &stratum);

/// "first hits of rays with": what a kernel says of volumes of its format.
std::string_view answers(Query query);

/// "// Level 2: svdag, 256 x 256 x 256 cells of 1 voxel a side." and an empty line before it.
std::string levelComment(const Plan &plan, std::size_t index);

/// "ivec3(4, 4, 4)".
std::string intVector(Int3 v);

} // namespace voxc
