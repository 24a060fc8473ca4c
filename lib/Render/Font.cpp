// Short texts drawn into pictures.
#include "Font.h"

#include <algorithm>
#include <array>

namespace voxc {
namespace {

/// A character by its rows, '#' where it is inked; all are equally wide.
struct Glyph {
  char character;
  std::array<std::string_view, kGlyphHeight> rows;

  int width() const { return static_cast<int>(rows[0].size()); }
};

constexpr Glyph kGlyphs[] = {
    {' ', {"..", "..", "..", "..", ".."}},
    {'.', {".", ".", ".", ".", "#"}},
    {'0', {"###", "#.#", "#.#", "#.#", "###"}},
    {'1', {".#.", "##.", ".#.", ".#.", "###"}},
    {'2', {"###", "..#", "###", "#..", "###"}},
    {'3', {"###", "..#", ".##", "..#", "###"}},
    {'4', {"#.#", "#.#", "###", "..#", "..#"}},
    {'5', {"###", "#..", "###", "..#", "###"}},
    {'6', {"###", "#..", "###", "#.#", "###"}},
    {'7', {"###", "..#", "..#", ".#.", ".#."}},
    {'8', {"###", "#.#", "###", "#.#", "###"}},
    {'9', {"###", "#.#", "###", "..#", "###"}},
    {'A', {".#.", "#.#", "###", "#.#", "#.#"}},
    {'B', {"##.", "#.#", "##.", "#.#", "##."}},
    {'C', {".##", "#..", "#..", "#..", ".##"}},
    {'D', {"##.", "#.#", "#.#", "#.#", "##."}},
    {'E', {"###", "#..", "##.", "#..", "###"}},
    {'F', {"###", "#..", "##.", "#..", "#.."}},
    {'G', {".###", "#...", "#.##", "#..#", ".###"}},
    {'H', {"#.#", "#.#", "###", "#.#", "#.#"}},
    {'I', {"###", ".#.", ".#.", ".#.", "###"}},
    {'J', {"..#", "..#", "..#", "#.#", ".#."}},
    {'K', {"#.#", "#.#", "##.", "#.#", "#.#"}},
    {'L', {"#..", "#..", "#..", "#..", "###"}},
    {'M', {"#...#", "##.##", "#.#.#", "#...#", "#...#"}},
    {'N', {"#..#", "##.#", "#.##", "#..#", "#..#"}},
    {'O', {".#.", "#.#", "#.#", "#.#", ".#."}},
    {'P', {"##.", "#.#", "##.", "#..", "#.."}},
    {'Q', {".##.", "#..#", "#..#", "#.#.", ".#.#"}},
    {'R', {"##.", "#.#", "##.", "#.#", "#.#"}},
    {'S', {".##", "#..", ".#.", "..#", "##."}},
    {'T', {"###", ".#.", ".#.", ".#.", ".#."}},
    {'U', {"#.#", "#.#", "#.#", "#.#", "###"}},
    {'V', {"#.#", "#.#", "#.#", "#.#", ".#."}},
    {'W', {"#...#", "#...#", "#.#.#", "##.##", "#...#"}},
    {'X', {"#.#", "#.#", ".#.", "#.#", "#.#"}},
    {'Y', {"#.#", "#.#", ".#.", ".#.", ".#."}},
    {'Z', {"###", "..#", ".#.", "#..", "###"}},
};

/// The character's glyph, or a blank.
const Glyph &glyphOf(char character) {
  const Glyph *found = std::ranges::find(kGlyphs, character, &Glyph::character);
  return found == std::end(kGlyphs) ? kGlyphs[0] : *found;
}

void drawGlyph(Picture &picture, const Glyph &glyph, int x, int y, int scale, std::uint32_t pixel) {
  for (int row = 0; row < kGlyphHeight; ++row)
    for (int column = 0; column < glyph.width(); ++column)
      if (glyph.rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == '#')
        fillRectangle(picture, x + column * scale, y + row * scale, scale, scale, pixel);
}

} // namespace

int textWidth(std::string_view text, int scale) {
  int cells = text.empty() ? 0 : -1;
  for (char character : text)
    cells += glyphOf(character).width() + 1;
  return cells * scale;
}

void drawText(Picture &picture, std::string_view text, int x, int y, int scale, std::uint32_t pixel) {
  for (char character : text) {
    const Glyph &glyph = glyphOf(character);
    drawGlyph(picture, glyph, x, y, scale, pixel);
    x += (glyph.width() + 1) * scale;
  }
}

void fillRectangle(Picture &picture, int x, int y, int width, int height, std::uint32_t pixel) {
  int right = std::min(x + width, picture.width);
  int bottom = std::min(y + height, picture.height);
  for (int row = std::max(y, 0); row < bottom; ++row)
    for (int column = std::max(x, 0); column < right; ++column)
      picture.pixels[std::size_t(row) * std::size_t(picture.width) + std::size_t(column)] = pixel;
}

} // namespace voxc
