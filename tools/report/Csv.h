// All cells as a table of comma-separated values, for spreadsheets and scripts.
#pragma once

#include "report/Catalogue.h"

#include <string>

namespace voxc::report {

/// A line of headings and one for each cell, in their order, as RFC 4180 has it. Figures are in the units
/// that their headings say, with all of their digits; those that were not taken are empty.
std::string toCsv(const Catalogue &catalogue);

} // namespace voxc::report
