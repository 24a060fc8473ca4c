// Reading of files that a library may not survive.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"

#include <cstdint>
#include <functional>
#include <string>

namespace voxc {

/// Calls `read` in a process of its own, which ends then: what crashes there is an error here, and so is what
/// takes more than 2 minutes of a processor, or more memory than `memory` bytes beside what this process has.
/// `read` returns what is wrong, or nothing. Errors: the sentence of `read`, or of its end; interrupted.
Expected<void> tryToRead(const std::function<std::string()> &read, std::uint64_t memory,
                         const Progress &progress);

} // namespace voxc
