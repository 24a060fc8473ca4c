// Decoding of compressed images: PNG, JPEG, TGA, BMP and what else stb_image knows.
#pragma once

#include "voxc/Mesh/TriangleMesh.h"

#include <cstddef>
#include <span>

namespace voxc {

/// Decodes an image to RGBA8. Errors: not an image that is known, broken, or more than 2^26 texels.
Expected<Texture> decodeImage(std::span<const std::byte> bytes);

} // namespace voxc
