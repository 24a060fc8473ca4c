// Trees to GLSL. Other languages are printers of their own: Glsl/Printer.h.
#pragma once

#include "Glsl/Tree.h"

#include <string>

namespace voxc::glsl {

/// The text of a module, in lines of at most 120 columns. Declarations keep their order and their comments.
std::string print(const Module &module);

/// The text of an expression, in one line.
std::string print(const Expression &expression);

} // namespace voxc::glsl
