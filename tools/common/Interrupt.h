// SIGINT and SIGTERM as a flag that long work asks for.
#pragma once

#include <atomic>

namespace voxc::tool {

/// From the first call on, the first SIGINT or SIGTERM sets the flag; a second one ends the process as usual,
/// and so does a second that passes, with the exit code of an interrupt, unless `heedInterrupt` was called.
const std::atomic<bool> &catchInterrupts();

/// Says that the work has ended, and that what is left to do may take its time.
void heedInterrupt();

} // namespace voxc::tool
