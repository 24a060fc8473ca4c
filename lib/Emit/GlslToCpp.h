// The functions of a kernel as members of a C++ class.
#pragma once

#include <string>
#include <string_view>

namespace voxc {

/// Writes GLSL as C++ that means the same beside voxc_glsl.h, as the body of a class: `inout` and `out`
/// parameters become references, `const` ones references to const; constants become static members; numbers
/// with a point or an exponent become floats, which they are in GLSL.
///
/// Two languages share the rest, as long as the text has no swizzles of several components, no array
/// constructors, no arrays as parameters or results (a struct carries one) and no macros.
std::string glslToCpp(std::string_view glsl);

} // namespace voxc
