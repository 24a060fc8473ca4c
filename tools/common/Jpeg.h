// Pictures as JPEG.
#pragma once

#include "voxc/Render/Picture.h"

#include <string>

namespace voxc::tool {

/// The picture as the bytes of a JPEG file; `quality` is 1 to 100.
std::string encodeJpeg(const Picture &picture, int quality);

} // namespace voxc::tool
