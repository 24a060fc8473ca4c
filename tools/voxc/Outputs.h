// Looking at where results shall go before any work is done for them.
#pragma once

#include "voxc/Support/Error.h"

#include <string>

namespace voxc::tool {

/// Whether `path` can become a file: "-" and "" always; not a directory, and its folder exists.
/// Errors: `Input`.
Expected<void> checkOutputFile(const std::string &path);

/// Makes the folder `path` with its parents if it is not there. Errors: `Input` if it is a file,
/// `Environment`.
Expected<void> makeOutputFolder(const std::string &path);

} // namespace voxc::tool
