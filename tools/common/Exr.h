// Pictures of light as OpenEXR.
#pragma once

#include <span>
#include <string>

namespace voxc::tool {

/// The bytes of an OpenEXR file of one part: scan lines of 32-bit floats, uncompressed, with the channels A,
/// B, G and R. `light` has red, green, blue and alpha of each pixel, in rows from the top, linear.
std::string encodeExr(std::span<const float> light, int width, int height);

} // namespace voxc::tool
