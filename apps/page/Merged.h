// Two texts that are mostly alike as one.
#pragma once

#include <string>
#include <string_view>

namespace voxc::page {

/// The lines of two texts in order, with what a line begins with: a blank where both have it, a minus where
/// the first has it alone, a plus where the second has. Without the lines of the one or the other, and
/// without the first character of each line, it is the second or the first again. Memory grows as the product
/// of their numbers of lines.
std::string merged(std::string_view first, std::string_view second);

} // namespace voxc::page
