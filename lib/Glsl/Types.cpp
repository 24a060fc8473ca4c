// The types that GLSL has, and what its functions return.
#include "Glsl/Types.h"

#include <algorithm>
#include <array>

namespace voxc::glsl {
namespace {

struct VectorKind {
  std::string_view component;
  std::string_view prefix; ///< Of vectors of it.
};

constexpr std::array<VectorKind, 5> kVectors = {
    {{"float", "vec"}, {"int", "ivec"}, {"uint", "uvec"}, {"bool", "bvec"}, {"double", "dvec"}}};

/// What a function returns of the shape of its first argument.
enum class Result { Same, Bools, Bool, Float, Floats, Int, Ints, Uint, Uints };

struct Builtin {
  std::string_view name;
  Result result;
};

constexpr std::array<Builtin, 43> kBuiltins = {{
    {"abs", Result::Same},
    {"min", Result::Same},
    {"max", Result::Same},
    {"clamp", Result::Same},
    {"mix", Result::Same},
    {"floor", Result::Same},
    {"fma", Result::Same},
    {"normalize", Result::Same},
    {"length", Result::Float},
    {"all", Result::Bool},
    {"any", Result::Bool},
    {"not", Result::Same},
    {"lessThan", Result::Bools},
    {"lessThanEqual", Result::Bools},
    {"greaterThan", Result::Bools},
    {"greaterThanEqual", Result::Bools},
    {"equal", Result::Bools},
    {"notEqual", Result::Bools},
    {"floatBitsToInt", Result::Ints},
    {"floatBitsToUint", Result::Uints},
    {"intBitsToFloat", Result::Floats},
    {"uintBitsToFloat", Result::Floats},
    {"bitCount", Result::Ints},
    {"findLSB", Result::Ints},
    {"findMSB", Result::Ints},
    {"uaddCarry", Result::Same},
    {"usubBorrow", Result::Same},
    {"umulExtended", Result::Same},
    {"atomicAdd", Result::Same},
    {"isinf", Result::Bools},
    {"isnan", Result::Bools},
    {"sqrt", Result::Same},
    {"trunc", Result::Same},
    {"roundEven", Result::Same},
    {"round", Result::Same},
    {"fract", Result::Same},
    {"pow", Result::Same},
    {"exp", Result::Same},
    {"sin", Result::Same},
    {"cos", Result::Same},
    {"acos", Result::Same},
    {"cross", Result::Same},
    {"dot", Result::Float},
}};

const Builtin *find(std::string_view name) {
  const auto builtin = std::ranges::find(kBuiltins, name, &Builtin::name);
  return builtin == kBuiltins.end() ? nullptr : &*builtin;
}

} // namespace

Shape shapeOf(std::string_view type) {
  for (const VectorKind &kind : kVectors) {
    if (type == kind.component)
      return {kind.component, 1};
    const std::string_view size = type.substr(std::min(kind.prefix.size(), type.size()));
    if (type.starts_with(kind.prefix) && size.size() == 1 && size >= "2" && size <= "4")
      return {kind.component, size[0] - '0'};
  }
  return {type, 0};
}

std::string typeOf(std::string_view component, int size) {
  const auto kind = std::ranges::find(kVectors, component, &VectorKind::component);
  return size == 1 || kind == kVectors.end() ? std::string(component)
                                             : std::string(kind->prefix) + std::to_string(size);
}

std::string swizzleOf(std::string_view type, std::string_view members) {
  const Shape shape = shapeOf(type);
  const std::string_view components =
      std::string_view("xyzw").substr(0, static_cast<std::size_t>(shape.size));
  const bool isOne = shape.size > 1 && members.size() <= 4 &&
                     members.find_first_not_of(components) == std::string_view::npos;
  return isOne ? typeOf(shape.component, static_cast<int>(members.size())) : "";
}

std::string builtinType(std::string_view function, std::string_view first) {
  const Builtin *const builtin = find(function);
  const Shape shape = shapeOf(first);
  if (!builtin || !shape.isNumeric())
    return "";
  constexpr std::array<std::string_view, 9> kComponents = {"",    "bool", "bool", "float", "float",
                                                           "int", "int",  "uint", "uint"};
  const bool isOne = builtin->result == Result::Bool || builtin->result == Result::Float ||
                     builtin->result == Result::Int || builtin->result == Result::Uint;
  return builtin->result == Result::Same
             ? std::string(first)
             : typeOf(kComponents[static_cast<std::size_t>(builtin->result)], isOne ? 1 : shape.size);
}

} // namespace voxc::glsl
