// What a language calls what GLSL has another name for.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace voxc::glsl {

struct Spelling {
  std::string_view glsl;
  std::string_view here;
};

/// "" if it has the same name, or is not of these.
template <std::size_t size>
constexpr std::string_view spelled(const std::array<Spelling, size> &spellings, std::string_view name) {
  const auto found = std::ranges::find(spellings, name, &Spelling::glsl);
  return found == spellings.end() ? std::string_view() : found->here;
}

/// The functions that compare vectors, as operators that do so for each component.
constexpr std::string_view comparisonOf(std::string_view function) {
  constexpr std::array<Spelling, 6> kComparisons = {{{"lessThan", "<"},
                                                     {"lessThanEqual", "<="},
                                                     {"greaterThan", ">"},
                                                     {"greaterThanEqual", ">="},
                                                     {"equal", "=="},
                                                     {"notEqual", "!="}}};
  return spelled(kComparisons, function);
}

} // namespace voxc::glsl
