// Pictures as the bytes of image files: rows from the top, of RGBA8 words with R in the low byte, or of
// light.
#pragma once

#include "voxc/Support/Error.h"

#include <cstdint>
#include <span>
#include <string>

namespace voxc {

/// A PNG of 8 bits a channel. Error: `Environment`, with what libpng says.
Expected<std::string> encodePng(std::span<const std::uint32_t> words, int width, int height);

/// A JPEG, without alpha; `quality` is 1 to 100. Error: `Environment`, with what libjpeg-turbo says, as of
/// more than 65500 pixels a side.
Expected<std::string> encodeJpeg(std::span<const std::uint32_t> words, int width, int height, int quality);

/// An OpenEXR file of one part: scan lines of 32-bit floats, uncompressed, with the channels A, B, G and R.
/// `light` has red, green, blue and alpha of each pixel, linear.
std::string encodeExr(std::span<const float> light, int width, int height);

/// The same of a picture's colours, made linear, and opaque.
std::string encodeExr(std::span<const std::uint32_t> words, int width, int height);

} // namespace voxc
