// Colours of labels.
#include "voxc/Volume/LabelColour.h"

#include <algorithm>
#include <cmath>

namespace voxc {

std::uint32_t labelColour(std::uint32_t label) {
  constexpr double kGoldenSection = 0.6180339887498949;
  const double turn = std::fmod(label * kGoldenSection, 1.0);
  const double least = label % 3 == 0 ? 0.25 : label % 3 == 1 ? 0.4 : 0.1;
  std::uint32_t word = 0xff000000u;
  for (std::uint32_t i = 0; i < 3; ++i) {
    // A hue's channels rise and fall along the circle, a third of it apart.
    const double place = std::fmod(turn + i / 3.0, 1.0);
    const double share = std::clamp(std::abs(place * 6 - 3) - 1, 0.0, 1.0);
    word |= static_cast<std::uint32_t>(std::lround(255 * (least + (0.95 - least) * share))) << 8 * i;
  }
  return word;
}

} // namespace voxc
