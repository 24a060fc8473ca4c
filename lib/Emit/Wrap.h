// Breaking the lines of emitted text.
#pragma once

#include <string>
#include <string_view>

namespace voxc {

/// GLSL or C++ whose lines, if they can be broken, have at most 120 columns. Lines of the preprocessor stay
/// as they are.
std::string wrapped(std::string_view text);

} // namespace voxc
