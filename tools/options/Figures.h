// Telling the figures of a run: as a few lines to a person, and all of them as JSON to --stats.
#pragma once

#include "common/Command.h"
#include "common/Json.h"

namespace voxc::tool {

/// Adds a file that was written to the figure `files`.
void addWritten(Json &figures, const std::string &path);

/// Prints what matters of the figures to standard error unless told to be quiet: what was read, made and
/// traced, and the files written. All figures go to --stats,
/// which must be none of these files (`Usage`).
Expected<void> tellFigures(const CommonOptions &common, const Json &figures);

/// True if what a command was asked for may go to standard output as text: not when the JSON goes there.
bool tellsOnStdout(const CommonOptions &common);

} // namespace voxc::tool
