// Which layouts can be edited: sub-volumes and nodes replaced, with all else left where it is.
#pragma once

#include "voxc/Layout/Layout.h"

#include <string>

namespace voxc {

/// Why volumes of this layout cannot be edited in place, and what would be right, as one sentence without a
/// full stop; "" if they can. They can be built anew all the same (`Constructor::edit`).
std::string whyNoEdits(const Layout &layout);

} // namespace voxc
