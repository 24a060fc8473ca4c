// The table of styles.
#include "voxc/Render/Style.h"

#include <cstddef>

namespace voxc {

namespace {

constexpr StyleKind kStyles[] = {
    {Style::Lit, "colours in the light of a sun and a sky", 4, true, true, true, ""},
    {Style::Flat, "colours shaded by face, without shadows", 1, false, true, false, ""},
    {Style::Ambient, "white clay: how much of the sky each point sees", 4, true, false, true, ""},
    {Style::Normals, "the surface's direction: x, y and z as red, green and blue", 1, false, false, true, ""},
    {Style::Depth, "the distance from the eye, near to far", 1, false, false, false, "VOXELS AWAY"},
    {Style::Heatmap, "the lookups that each ray took, few to many", 1, false, false, false, "LOOKUPS A RAY"},
};

} // namespace

std::span<const StyleKind> styleKinds() { return kStyles; }

const StyleKind &kindOf(Style style) { return kStyles[static_cast<std::size_t>(style)]; }

} // namespace voxc
