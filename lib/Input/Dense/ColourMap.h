// Colour maps: what the samples of a dense volume look like.
#pragma once

#include "voxc/Support/Error.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace voxc {

/// In place of a map: words are the samples, whole numbers that label what is there.
inline constexpr std::string_view kLabels = "labels";

/// The 256 opaque colours of the map `name`. Error: there is none, naming those there are.
Expected<std::array<std::uint32_t, 256>> colourMap(std::string_view name);

} // namespace voxc
