// Numbers drawn into pictures.
#pragma once

#include "voxc/Trace/Picture.h"

#include <cstdint>
#include <string_view>

namespace voxc {

/// Cells of a glyph; a text advances by one cell more.
inline constexpr int kGlyphWidth = 3;
inline constexpr int kGlyphHeight = 5;

/// Pixels across a text whose cells are `scale` pixels a side.
int textWidth(std::string_view text, int scale);

/// Draws digits with their top left corner at (x, y); what falls outside of the picture is left out, and
/// characters that are no digits stay blank.
void drawDigits(Picture &picture, std::string_view text, int x, int y, int scale, std::uint32_t pixel);

/// Fills the part of a rectangle that lies in the picture.
void fillRectangle(Picture &picture, int x, int y, int width, int height, std::uint32_t pixel);

} // namespace voxc
