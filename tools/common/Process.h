// What a command asks of its process: signals that would end it become errors, and the stack is large enough.
#pragma once

#include "voxc/Support/Error.h"

namespace voxc::tool {

/// Called once, before anything else is done. Error: `Environment`, the stack is too small and may not grow.
Expected<void> prepareProcess();

} // namespace voxc::tool
