// What a command asks of its process: signals that would end it become errors, formats have no more levels
// than the environment allows, the heap lies on huge pages, and the stack is large enough.
#pragma once

#include "voxc/Support/Error.h"

namespace voxc::tool {

/// Called once, before anything else is done. Errors: `Environment`, the stack is too small and may not grow;
/// `Usage`, a variable of the environment that is no number of levels.
Expected<void> prepareProcess();

} // namespace voxc::tool
