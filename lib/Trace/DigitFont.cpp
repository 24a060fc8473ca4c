// Numbers drawn into pictures.
#include "DigitFont.h"

#include <algorithm>

namespace voxc {
namespace {

/// The rows of each digit, '#' where it is inked.
constexpr std::string_view kDigits[10][kGlyphHeight] = {
    {"###", "#.#", "#.#", "#.#", "###"}, {".#.", "##.", ".#.", ".#.", "###"},
    {"###", "..#", "###", "#..", "###"}, {"###", "..#", ".##", "..#", "###"},
    {"#.#", "#.#", "###", "..#", "..#"}, {"###", "#..", "###", "..#", "###"},
    {"###", "#..", "###", "#.#", "###"}, {"###", "..#", "..#", ".#.", ".#."},
    {"###", "#.#", "###", "#.#", "###"}, {"###", "#.#", "###", "..#", "###"},
};

void drawDigit(Picture &picture, char digit, int x, int y, int scale, std::uint32_t pixel) {
  for (int row = 0; row < kGlyphHeight; ++row)
    for (int column = 0; column < kGlyphWidth; ++column)
      if (kDigits[digit - '0'][row][column] == '#')
        fillRectangle(picture, x + column * scale, y + row * scale, scale, scale, pixel);
}

} // namespace

int textWidth(std::string_view text, int scale) {
  int cells = static_cast<int>(text.size()) * (kGlyphWidth + 1) - 1;
  return text.empty() ? 0 : cells * scale;
}

void drawDigits(Picture &picture, std::string_view text, int x, int y, int scale, std::uint32_t pixel) {
  for (char character : text) {
    if (character >= '0' && character <= '9')
      drawDigit(picture, character, x, y, scale, pixel);
    x += (kGlyphWidth + 1) * scale;
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
