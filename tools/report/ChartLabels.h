// Names beside the points of a chart.
#pragma once

#include "plot/Scale.h"
#include "report/FrontierChart.h"

#include <string>

namespace voxc::report {

/// The labels as SVG, in one group for each width that they are placed for, of which style.css shows the one
/// that fits: leading points first, then others where there is room left. A leading one that finds no room
/// is left to the table below.
std::string chartLabels(const Chart &chart, const plot::Scale &x, const plot::Scale &y);

} // namespace voxc::report
