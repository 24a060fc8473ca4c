// The colours in which labels are shown and exported.
#pragma once

#include <cstdint>

namespace voxc {

/// The colour of a label as a word, R in the low byte, opaque: hues a golden section apart, so that labels
/// next to each other never look alike. Of 255 labels no two have the same.
std::uint32_t labelColour(std::uint32_t label);

} // namespace voxc
