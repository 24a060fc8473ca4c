// The report of `voxc bench`: one HTML file that needs nothing else.
#pragma once

#include "report/Cells.h"

#include <string>
#include <vector>

namespace voxc::report {

struct Report {
  std::string html;
  std::vector<std::string> notes; ///< What could not be shown, and why.
};

/// The report of these cells; pictures are read from where the records say.
Report makeReport(const std::vector<Cell> &cells);

} // namespace voxc::report
