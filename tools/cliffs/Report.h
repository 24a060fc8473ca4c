// The worst of many findings, and what kinds of situations they are.
#pragma once

#include "Finding.h"

#include <vector>

namespace voxc::cliffs {

/// Prints the findings of the highest ratios, and then the kinds of situations: by rays, by number, by what
/// is asked and by device, with how many there were and how far off they are.
void printReport(const std::vector<Finding> &findings, std::size_t worst);

/// One finding on one line.
void printFinding(const Finding &finding);
void printHead();

} // namespace voxc::cliffs
