// Breaking the lines of emitted text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace voxc::glsl {

/// Those of a line, at most.
inline constexpr std::size_t kMostColumns = 120;

/// GLSL or C++ whose lines, if they can be broken, have at most `kMostColumns`. Lines of the preprocessor
/// stay as they are.
std::string wrapped(std::string_view text);

} // namespace voxc::glsl
