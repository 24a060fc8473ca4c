// What a leaf of a kernel may name without declaring it: what other leaves declare, and the constants of
// plans and levels.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace voxc::test {

/// The paths of all leaves: the files of shaders-runtime that are GLSL of the kernel language.
std::vector<std::string> leaves();

/// Those that define functions of GLSL for languages without them, such as GLSL ES 3.00.
std::vector<std::string> builtins();

/// Declarations for a leaf, so that prelude and leaf are one text that any GLSL compiler takes: functions by
/// their prototypes alone.
std::string preludeOf(std::string_view path);

} // namespace voxc::test
