// Kernel functions as part of the shaders and programs of others.
#pragma once

#include <string>
#include <string_view>

namespace voxc {

/// Writes GLSL as text that is GLSL and C++ alike, between header/begin.glsl and header/end.glsl, and that
/// meets no name of others: what it declares at its outermost level, functions, structures and constants,
/// gets `prefix` before its name, unless it has it. Each function that calls `load_word`, itself or through
/// others, gets a volume to load from as its first parameter. The rest is as for `glslToCpp`, and the same in
/// both languages by the macros of header/begin.glsl.
std::string embedded(std::string_view glsl, std::string_view prefix);

} // namespace voxc
