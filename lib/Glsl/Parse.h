// GLSL to a tree.
#pragma once

#include "voxc/Support/Error.h"

#include "Glsl/Tree.h"

#include <string_view>

namespace voxc::glsl {

/// Reads what kernels are written in: functions, structs, constants and variables, words outside of the
/// kernel, and eight kinds of statement. Not of it: switch, do, comments between /* and */, macros with
/// arguments, and comments in the middle of an expression. Error: "line N: found 'x' where .. would be
/// right".
Expected<Module> parse(std::string_view text);

} // namespace voxc::glsl
