// The chart of a search in the panel.
#pragma once

#include "view/SearchPoints.h"

#include <cstddef>
#include <optional>
#include <string>

namespace voxc::view {

/// Draws the chart as wide as there is room, the point of the format `shown` marked. Returns the point that
/// was clicked. Precondition: there is a point.
std::optional<std::size_t> drawChart(const SearchPoints &search, const std::string &shown);

} // namespace voxc::view
