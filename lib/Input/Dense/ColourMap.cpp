// Colour maps as straight lines between a few colours.
#include "Input/Dense/ColourMap.h"

#include "voxc/Source/VoxelSource.h"

#include <cstddef>

namespace voxc {

namespace {

using Colour = std::array<int, 3>;

struct MapRow {
  std::string_view name;
  std::array<Colour, 4> colours; ///< Evenly spread.
};

constexpr std::array<MapRow, 4> kMaps{{
    {"grey", {{{0, 0, 0}, {85, 85, 85}, {170, 170, 170}, {255, 255, 255}}}},
    {"heat", {{{20, 8, 12}, {176, 24, 16}, {244, 152, 24}, {255, 252, 224}}}},
    {"dusk", {{{58, 16, 92}, {46, 94, 140}, {44, 164, 118}, {246, 230, 44}}}},
    {"polar", {{{28, 60, 180}, {168, 188, 230}, {232, 180, 160}, {180, 24, 28}}}},
}};

std::uint32_t colourAt(const MapRow &map, int place) {
  // Three lines of 85 steps each.
  constexpr int kSteps = 85;
  const auto line = static_cast<std::size_t>(place < 3 * kSteps ? place / kSteps : 2);
  const int step = place - static_cast<int>(line) * kSteps;
  std::array<std::uint32_t, 3> channels;
  for (std::size_t i = 0; i < 3; ++i) {
    const int from = map.colours[line][i];
    const int to = map.colours[line + 1][i];
    channels[i] = static_cast<std::uint32_t>(from + ((to - from) * step + kSteps / 2) / kSteps);
  }
  return rgba(channels[0], channels[1], channels[2]);
}

} // namespace

Expected<std::array<std::uint32_t, 256>> colourMap(std::string_view name) {
  std::string names;
  for (const MapRow &map : kMaps) {
    names += (names.empty() ? "" : ", ") + std::string(map.name);
    if (map.name != name)
      continue;
    std::array<std::uint32_t, 256> colours;
    for (std::size_t i = 0; i < colours.size(); ++i)
      colours[i] = colourAt(map, static_cast<int>(i));
    return colours;
  }
  return Error::usage("there is no colour map '" + std::string(name) + "'; there are " + names +
                      " and, for labels, " + std::string(kLabels));
}

} // namespace voxc
