// Whether a module is one: names, and types.
#pragma once

#include "voxc/Support/Error.h"

#include "Glsl/Tree.h"

#include <span>
#include <string_view>

namespace voxc::glsl {

/// A function, or a variable, that text around a module declares: its name, and its type or what it returns.
struct External {
  std::string_view name;
  std::string_view type;
};

/// Finds the type of each expression, and checks that all names are declared before they are used, that
/// functions take what they are given, and that operators, assignments and results fit. Types are as strict
/// as in the strictest of the languages that kernels are printed in: none becomes another by itself, but that
/// a float may be a double, which only GLSL and C++ have, that a number may stand beside a vector, and that
/// signs do not matter to the number of bits that something is shifted by. Error: the declaration, and what
/// is wrong in it.
Expected<void> verify(Module &module, std::span<const External> externals = {});

} // namespace voxc::glsl
