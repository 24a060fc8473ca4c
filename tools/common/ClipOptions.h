// The options that cut away what is not to be seen.
#pragma once

#include "CommandLine.h"

#include "voxc/Support/Error.h"
#include "voxc/Trace/Clip.h"

#include <string>
#include <vector>

namespace voxc::tool {

/// As they were written; empty: nothing is cut away.
struct ClipOptions {
  std::string box;                 ///< "[model:]X0,Y0,Z0,X1,Y1,Z1".
  std::vector<std::string> planes; ///< "[model:]NX,NY,NZ,D".

  bool isGiven() const { return !box.empty() || !planes.empty(); }
};

/// Adds --clip-box and --clip-plane to a command.
void addClipOptions(const CommandLine &command, ClipOptions &options);

/// What they keep of a volume whose units are the model's by `voxelToModel`. Error: `Usage`, one is
/// malformed.
Expected<Clip> clipOf(const ClipOptions &options, const Transform &voxelToModel = {});

} // namespace voxc::tool
