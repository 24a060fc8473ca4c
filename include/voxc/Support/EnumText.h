// Enumerations as text: the names of the values stand beside the enumeration, and printing and parsing draw
// from them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace voxc {

/// The names of an enumeration's values, in their order; specialised beside each that has text.
template <typename Enum> inline constexpr std::array<std::string_view, 0> kEnumNames = {};

template <typename Enum>
concept Named = (kEnumNames<Enum>.size() > 0);

template <Named Enum> constexpr std::string_view toString(Enum value) {
  return kEnumNames<Enum>[static_cast<std::size_t>(value)];
}

/// The value of this name, or nothing.
template <Named Enum> constexpr std::optional<Enum> fromString(std::string_view name) {
  for (std::size_t i = 0; i < kEnumNames<Enum>.size(); ++i)
    if (kEnumNames<Enum>[i] == name)
      return static_cast<Enum>(i);
  return std::nullopt;
}

} // namespace voxc
