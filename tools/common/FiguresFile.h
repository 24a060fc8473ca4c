// Where the figures of a command may go.
#pragma once

#include "CommandLine.h"

#include "voxc/Support/Error.h"

#include <string>

namespace voxc::tool {

/// Refuses a file for `--stats` that another option or word of the command names too, in whatever way: as
/// part of an input (`V.hvx#2`, `raw:8x8x8:uint8:FILE`, `V.hvx@0,0,0`), through links, as one of a numbered
/// set, or as the journal of a volume. Figures are written last, over whatever has their name. Pipes and
/// devices take both. Error: `Usage`.
Expected<void> checkFiguresFile(const CommandLine &command);

/// Refuses `stats`, the file of `--stats`, if the command makes `made` under a name that no option gave: that
/// file, one of a numbered set, or whatever lies in that folder. Error: `Usage`.
Expected<void> checkFiguresApart(const std::string &stats, const std::string &made);

} // namespace voxc::tool
