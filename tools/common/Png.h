// Pictures as PNG files.
#pragma once

#include "voxc/Render/Picture.h"
#include "voxc/Support/Error.h"

#include <string>

namespace voxc::tool {

/// The picture as the bytes of a PNG file; empty if memory is out.
std::string encodePng(const Picture &picture);

/// Writes `picture` to `path` ("-" is standard output), whole or not at all. Errors: `Environment`.
Expected<void> writePng(const std::string &path, const Picture &picture);

} // namespace voxc::tool
