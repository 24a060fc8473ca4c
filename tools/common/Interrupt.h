// SIGINT, SIGTERM and SIGHUP as a flag that long work asks for.
#pragma once

#include <atomic>

namespace voxc::tool {

/// From the first call on, the first SIGINT, SIGTERM or SIGHUP (unless it is ignored) sets the flag; a second
/// one of its kind ends the process at once, and so does a second that passes, with the exit code of an
/// interrupt, unless `heedInterrupt` was called.
const std::atomic<bool> &catchInterrupts();

/// Says that the work has ended, and that what is left to do may take its time.
void heedInterrupt();

} // namespace voxc::tool
