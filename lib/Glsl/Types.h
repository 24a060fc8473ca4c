// Types by their names: numbers, and vectors of them.
#pragma once

#include <string>
#include <string_view>

namespace voxc::glsl {

/// So many numbers of a kind: "uvec3" is three of "uint". Of what is no number, such as a struct, the name
/// and 0.
struct Shape {
  std::string_view component;
  int size = 0;

  bool isNumeric() const { return size > 0; }
  bool operator==(const Shape &) const = default;
};

Shape shapeOf(std::string_view type);

/// "uvec3" of "uint" and 3; the component itself of 1.
std::string typeOf(std::string_view component, int size);

/// That of a type's member that is a swizzle, or of one component; "" if it is neither.
std::string swizzleOf(std::string_view type, std::string_view members);

/// What a function that the language has returns for arguments of which the first has a type; "" if there is
/// none of this name.
std::string builtinType(std::string_view function, std::string_view first);

} // namespace voxc::glsl
