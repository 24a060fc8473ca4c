// What a sweep found, as a table for people.
#pragma once

#include "sweep/Cells.h"

#include <vector>

namespace voxc::tool::bench {

/// Prints a line a cell to standard output, in tables by model, rays, precision and device, and what failed.
void printSummary(const std::vector<Cell> &cells);

} // namespace voxc::tool::bench
