// Passes: a module to one that means the same, in the way that a target needs it.
#pragma once

#include "Glsl/Tree.h"

#include <string>
#include <string_view>

namespace voxc::glsl {

/// Puts a prefix before the names of all functions, structs, constants and variables that stand outermost,
/// but those that have it. Members, parameters and variables of functions keep theirs.
void addPrefix(Module &module, std::string_view prefix);

/// Gives the function of this name, and all that cannot do without it, one more parameter, the first, which
/// they hand on.
void addParameter(Module &module, std::string_view function, const Parameter &parameter);

} // namespace voxc::glsl
