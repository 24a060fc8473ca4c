// Looking at where results shall go before any work is done for them.
#pragma once

#include "common/Command.h"
#include "voxc/Support/Error.h"

#include <string>

namespace voxc::tool {

/// Whether `path` can become a file: not a directory, its folder exists, and no edits of what is there wait
/// in a journal. Errors: `Input`; `Usage` for "-" and "".
Expected<void> checkOutputFile(const std::string &path);

/// The same, but "-" is standard output, unless the figures go there; nor do they go to a file of this name,
/// which may be one that no option gave.
Expected<void> checkOutput(const std::string &path, const CommonOptions &common);

/// Makes the folder `path` with its parents if it is not there. Errors: `Input` if it is a file,
/// `Environment`.
Expected<void> makeOutputFolder(const std::string &path);

} // namespace voxc::tool
