// What ImageJ writes into the description of a stack of pages.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace voxc {

/// How far apart samples are, in a unit.
struct StackSpacing {
  std::array<double, 3> steps{1, 1, 1};
  double metres = 0; ///< Of a step of 1; 0: not known.

  bool operator==(const StackSpacing &) const = default;
};

/// How many pictures the description tells, or 0. Of stacks above 4 GB only the first is a page.
std::uint64_t imageJImages(std::string_view description);

/// The spacing that ImageJ's description tells, with the pixels a unit of the page's resolution (0: not
/// said); nothing where it says none: neither `spacing` nor a unit that is no pixel.
std::optional<StackSpacing> imageJSpacing(std::string_view description,
                                          const std::array<double, 2> &pixelsAUnit);

} // namespace voxc
