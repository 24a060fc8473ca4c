// Units of length, as files and command lines write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace voxc {

/// Metres of a unit such as "mm" or "feet"; nothing if it is none that is known.
std::optional<double> metresOf(std::string_view unit);

/// The short names of all units, for messages.
std::string unitNames();

/// The short name of the unit of so many metres; nothing if there is none.
std::optional<std::string> unitName(double metres);

} // namespace voxc
