// Short texts drawn into pictures.
#pragma once

#include "voxc/Render/Picture.h"

#include <cstdint>
#include <string_view>

namespace voxc {

/// Cells from the top of a glyph to its bottom.
inline constexpr int kGlyphHeight = 5;

/// Pixels across a text whose cells are `scale` pixels a side.
int textWidth(std::string_view text, int scale);

/// Draws digits and capital letters with their top left corner at (x, y); what falls outside of the picture
/// is left out, and other characters stay blank.
void drawText(Picture &picture, std::string_view text, int x, int y, int scale, std::uint32_t pixel);

/// Fills the part of a rectangle that lies in the picture.
void fillRectangle(Picture &picture, int x, int y, int width, int height, std::uint32_t pixel);

} // namespace voxc
