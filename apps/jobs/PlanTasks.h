// The tasks of a build plan, as idempotent commands: what stands already is left as it is.
#pragma once

#include "common/Json.h"
#include "options/BuildArguments.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"

#include <string>

namespace voxc::tool {

/// Builds the parts `numbers` ("0,3,5-9") of the plan in the file `path`. Adds to the figures what was built
/// and what stood. Errors: `Usage`, a number that the plan has not; `Input`, the input has changed; those of
/// building.
Expected<void> buildParts(const std::string &path, const std::string &numbers,
                          const BuildArguments &arguments, const Progress &progress, Json &figures);

/// Does the merges `numbers` of the plan; the last merge writes the volume. Errors: the same; an output that
/// is merged is missing or broken.
Expected<void> mergeParts(const std::string &path, const std::string &numbers,
                          const BuildArguments &arguments, const Progress &progress, Json &figures);

} // namespace voxc::tool
