// What is predicted of a format, as JSON.
#pragma once

#include "common/Json.h"
#include "voxc/Search/FormatPredictor.h"

#include <span>
#include <string>

namespace voxc::tool {

/// The format, its words, and what a ray of each set costs; `sets` has their names.
Json predictionFigures(const PredictedFormat &format, std::span<const std::string> sets);

} // namespace voxc::tool
