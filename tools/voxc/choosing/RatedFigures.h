// What is foretold of a format, as JSON.
#pragma once

#include "common/Json.h"
#include "voxc/Search/Rater.h"

#include <span>
#include <string>

namespace voxc::tool {

/// The format, its words, and what a ray of each set costs; `sets` has their names.
Json ratedFigures(const RatedFormat &format, std::span<const std::string> sets);

} // namespace voxc::tool
