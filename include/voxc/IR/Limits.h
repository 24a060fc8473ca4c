// How many levels formats may have: whoever compiles what strangers send must know what that can cost.
#pragma once

#include <cstddef>

namespace voxc {

/// Of each axis of a format, which a level of more than one cell doubles: more levels are of use to nobody.
inline constexpr std::size_t kDefaultLevels = 21;

/// No process can allow more: kernels and checks go down a call a level. Code for so many levels may take
/// minutes to compile.
inline constexpr std::size_t kMostLevels = 64;

/// How many levels the formats have at most that this process takes from now on, 1 to kMostLevels; at first
/// kDefaultLevels. Those that it has already stay.
void allowLevels(std::size_t most);
std::size_t allowedLevels();

} // namespace voxc
