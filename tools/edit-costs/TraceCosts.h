// What rays cost through an edited volume, beside a build of the same voxels.
#pragma once

#include "voxc/Construct/EditableVolume.h"

#include <string>

namespace voxc::edits {

/// Traces the rays of a file through the volume as it is and through its compaction, in turn, and prints both
/// times and how many hits differ. Errors: as of the file, the tracers and the build; hits that differ
/// (`Input`).
Expected<void> compareTraces(EditableVolume &edited, const std::string &rays, const std::string &device);

} // namespace voxc::edits
