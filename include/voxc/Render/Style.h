// What a picture shows: a table of styles.
#pragma once

#include "voxc/Support/EnumText.h"

#include <span>
#include <string_view>

namespace voxc {

enum class Style {
  Lit,     ///< Colours in the light of a sun and of a sky that what stands around hides.
  Flat,    ///< Colours, shaded by face.
  Ambient, ///< How much of the sky a point sees, as if all were of white clay.
  Normals, ///< The surface's direction as a colour.
  Depth,   ///< The distance from the eye, as a map.
  Heatmap, ///< The lookups that a ray took, as a map.
};

template <>
inline constexpr std::array<std::string_view, 6> kEnumNames<Style> = {"lit",     "flat",  "ao",
                                                                      "normals", "depth", "heatmap"};

/// A row of the table.
struct StyleKind {
  Style style;
  std::string_view summary; ///< In a line.
  unsigned samples;         ///< Rays a pixel, where nobody says how many.
  bool isLit;               ///< It takes rays to the sky.
  bool hasColours;          ///< It shows the voxels' own.
  bool needsNormals;        ///< It takes the direction of surfaces.
  std::string_view unit;    ///< Of a map's numbers; empty: it is no map.
};

/// All styles, in the order of the enumeration.
std::span<const StyleKind> styleKinds();
const StyleKind &kindOf(Style style);

} // namespace voxc
