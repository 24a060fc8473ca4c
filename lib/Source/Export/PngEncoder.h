// Pictures as the bytes of a .png file.
#pragma once

#include "voxc/Support/Error.h"

#include <cstdint>
#include <span>
#include <string>

namespace voxc {

/// A picture of RGBA words, row by row from the top. Errors: what the encoder says.
Expected<std::string> encodePng(std::span<const std::uint32_t> words, std::int32_t width,
                                std::int32_t height);

} // namespace voxc
