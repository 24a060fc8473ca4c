// What is done with the voxels of an input once it is open.
#pragma once

#include "voxc/Input/Input.h"

namespace voxc {

/// Drops or fills the inside of an input, unless that was done, and crops it, as `options` say; its
/// provenance and notes tell of it. Errors: as `dropInterior`, `fillInterior` and `crop`.
Expected<void> applyChanges(Input &input, const InputOptions &options);

} // namespace voxc
