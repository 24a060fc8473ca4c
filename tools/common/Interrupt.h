// SIGINT and SIGTERM as a flag that long work asks for.
#pragma once

#include <atomic>

namespace voxc::tool {

/// From the first call on, the first SIGINT or SIGTERM sets the flag; a second one ends the process as usual.
const std::atomic<bool> &catchInterrupts();

} // namespace voxc::tool
