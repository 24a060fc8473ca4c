// How formats look in the report: their names and the families that marks tell apart.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::report {

struct FormatLook {
  std::string name;                  ///< "R(4³) G(7)": one spelling for each format, however it was written.
  std::size_t family = 0;            ///< Index into `families()`.
  std::vector<std::string> levels{}; ///< "R(4³)", "G(7)": the name in parts; none if it cannot be parsed.
};

/// The look of a format string; one that cannot be parsed keeps its text and belongs to the last family.
FormatLook lookOf(const std::string &format);

/// What the families are called, in the order of the legend.
std::span<const std::string_view> families();

} // namespace voxc::report
