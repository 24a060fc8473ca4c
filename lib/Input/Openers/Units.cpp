// The table of units.
#include "voxc/Input/Units.h"

#include "Support/Text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace voxc {

namespace {

struct Unit {
  std::string_view name;
  double metres;
  bool isShort = false; ///< The name that messages have.
};

constexpr std::array<Unit, 29> kUnits{
    {{"nm", 1e-9, true},    {"nanometer", 1e-9}, {"nanometre", 1e-9},  {"um", 1e-6, true},
     {"µm", 1e-6},          {"micron", 1e-6},    {"microns", 1e-6},    {"micrometer", 1e-6},
     {"micrometre", 1e-6},  {"mm", 1e-3, true},  {"millimeter", 1e-3}, {"millimetre", 1e-3},
     {"millimeters", 1e-3}, {"cm", 1e-2, true},  {"centimeter", 1e-2}, {"centimetre", 1e-2},
     {"m", 1, true},        {"meter", 1},        {"metre", 1},         {"meters", 1},
     {"km", 1e3, true},     {"kilometer", 1e3},  {"kilometre", 1e3},   {"in", 0.0254, true},
     {"inch", 0.0254},      {"inches", 0.0254},  {"ft", 0.3048, true}, {"foot", 0.3048},
     {"feet", 0.3048}}};

} // namespace

std::optional<Length> parseLength(std::string_view text) {
  Length length;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), length.value);
  std::string_view unit = text.substr(static_cast<std::size_t>(parsed.ptr - text.data()));
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  if (parsed.ec != std::errc() || !(length.value > 0) || !std::isfinite(length.value))
    return std::nullopt;
  if (unit.empty())
    return length;
  const auto metres = metresOf(unit);
  length.metres = metres.value_or(0);
  return metres ? std::optional(length) : std::nullopt;
}

std::optional<double> metresOf(std::string_view unit) {
  const std::string name = lowerCase(unit);
  for (const Unit &row : kUnits)
    if (row.name == name)
      return row.metres;
  return std::nullopt;
}

std::string unitNames() {
  std::string names;
  for (const Unit &row : kUnits)
    if (row.isShort)
      names += (names.empty() ? "" : " ") + std::string(row.name);
  return names;
}

std::optional<std::string> unitName(double metres) {
  for (const Unit &row : kUnits)
    if (row.isShort && row.metres == metres)
      return std::string(row.name);
  return std::nullopt;
}

} // namespace voxc
