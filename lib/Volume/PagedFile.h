// Whole volumes from compressed .hvx files.
#pragma once

#include "voxc/Volume/PagedVolume.h"
#include "voxc/Volume/Volume.h"

namespace voxc {

/// Decodes all pages into memory that grows with what was decoded, whatever the file claims. Errors: a
/// damaged page; `Environment`, no memory.
Expected<Volume> decodeAll(const PagedVolume &file, const LoadOptions &options);

} // namespace voxc
