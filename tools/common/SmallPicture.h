// Pictures made small enough to lie inside a page.
#pragma once

#include "voxc/Render/Picture.h"

#include <cstddef>
#include <string>

namespace voxc::tool {

/// The picture at most `width` pixels wide, each the mean of those that it covers.
Picture shrunk(const Picture &picture, int width);

/// The picture as a data: address (a JPEG in base64) of at most `mostBytes` characters, shrunk as far as that
/// takes; empty if it cannot be made so small.
std::string pictureAddress(const Picture &picture, std::size_t mostBytes);

} // namespace voxc::tool
