// Names of devices: as short as still keeps them apart.
#pragma once

#include "report/Cells.h"

#include <string>
#include <vector>

namespace voxc::report {

/// For each cell what its device is called: the name up to its brackets if that tells all devices of the
/// cells apart, else the whole name, then with threads, then with the processor.
std::vector<std::string> deviceNames(const std::vector<Cell> &cells);

} // namespace voxc::report
