// What the axes of charts show, so that charts side by side can be compared.
#pragma once

#include "report/Catalogue.h"
#include "report/FrontierChart.h"

#include <vector>

namespace voxc::report {

/// The range of each stage. Stages of one model and resolution have the sizes in common. Those whose speeds
/// count in the same have the speeds in common too, unless they are so far apart that the slower ones would
/// lie flat on the axis: then the fastest of a group is at most three times as fast as the next.
std::vector<ChartRange> chartRanges(const Catalogue &catalogue);

} // namespace voxc::report
