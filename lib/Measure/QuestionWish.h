// What a question wishes of a format.
#pragma once

#include "voxc/Measure/FormatTable.h"
#include "voxc/Search/Suggest.h"

namespace voxc::measure {

/// Error: `Usage` for an objective that there is not, or fewer rays than show what a packet costs.
Expected<Wish> wishOf(const FormatQuestion &question);

} // namespace voxc::measure
