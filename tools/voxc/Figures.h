// Telling the figures of a run: as lines to a person, and as JSON to --stats.
#pragma once

#include "common/Command.h"
#include "common/Json.h"

namespace voxc::tool {

/// Prints the figures to standard error unless told to be quiet, and writes --stats.
Expected<void> tellFigures(const CommonOptions &common, const Json &figures);

/// True if text for people may go to standard output: not when quiet, nor when the JSON goes there.
bool tellsOnStdout(const CommonOptions &common);

} // namespace voxc::tool
