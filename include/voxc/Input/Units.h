// Units of length, as files and command lines write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace voxc {

/// A length: a number of some unit.
struct Length {
  double value = 0;
  double metres = 0; ///< Of the unit; 0: it is that of the model, whatever that is.
};

/// Reads "0.05", "0.05m" or "2 mm". Nothing: it is no positive length, or its unit is none that is known.
std::optional<Length> parseLength(std::string_view text);

/// Metres of a unit such as "mm" or "feet"; nothing if it is none that is known.
std::optional<double> metresOf(std::string_view unit);

/// The short names of all units, for messages.
std::string unitNames();

/// The short name of the unit of so many metres; nothing if there is none.
std::optional<std::string> unitName(double metres);

} // namespace voxc
