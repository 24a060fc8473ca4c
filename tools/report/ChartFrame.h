// Where things lie in a chart. Places along x are shares of the width in percent, those along y pixels; the
// axes' words stand outside the frame, in margins that style.css gives it.
#pragma once

#include "plot/Scale.h"

#include <cstddef>
#include <string>

namespace voxc::report {

inline constexpr double kChartHeight = 300;

/// "12.3%".
std::string share(double value);
/// A place along x to a tenth of a pixel of any screen.
std::string fineShare(double value);

/// Both axes with their ticks, a line across for each of y, and what they are called.
std::string axes(const plot::Scale &x, const plot::Scale &y, const std::string &xName,
                 const std::string &yName);

/// Whether a chart of so many points draws them small.
bool isCrowded(std::size_t points);
/// The svg element of a chart with so many points.
std::string chartElement(std::size_t points, const std::string &content);

/// A reference to a family's mark: "#m2", or "#s2" for the small one.
std::string markReference(std::size_t family, bool isSmall = false);

} // namespace voxc::report
