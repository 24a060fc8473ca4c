// Slices through libpng.
#include "Input/Dense/PngSlice.h"

#include <png.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace voxc {

namespace {

constexpr std::uint64_t kMostCells = std::uint64_t{1} << 26;
/// No PNG has more texels a byte: deflate makes 1032 bytes of one, of one bit a texel.
constexpr std::uint64_t kMostCellsAByte = 8400;
constexpr std::uint64_t kFewCells = 1 << 16;

/// A picture whose header has been read; freed on every way out.
struct OpenPng {
  explicit OpenPng(std::span<const std::byte> bytes) {
    std::memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    isOpen = png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) != 0;
  }
  ~OpenPng() { png_image_free(&image); }
  OpenPng(const OpenPng &) = delete;
  OpenPng &operator=(const OpenPng &) = delete;

  bool has(png_uint_32 flag) const { return (image.format & flag) != 0; }

  png_image image;
  bool isOpen = false;
};

/// Of pictures without alpha, black is empty: the word 0.
void clearBlack(std::span<std::byte> cells) {
  constexpr std::uint32_t kBlack = 0xff000000;
  for (std::size_t at = 0; at < cells.size(); at += 4) {
    std::uint32_t word = 0;
    std::memcpy(&word, cells.data() + at, sizeof word);
    if (word == kBlack)
      std::memset(cells.data() + at, 0, sizeof word);
  }
}

} // namespace

Expected<PngSlice> readPngSlice(std::span<const std::byte> bytes) {
  const OpenPng png(bytes);
  if (!png.isOpen)
    return Error::input(std::string("it is no PNG picture, or a broken one: ") + png.image.message);
  if (png.has(PNG_FORMAT_FLAG_LINEAR))
    return Error::input("it has 16 bits a channel; slices of 8 are read");
  const std::uint64_t cells = std::uint64_t{png.image.width} * png.image.height;
  if (cells > kMostCells || cells > kFewCells + kMostCellsAByte * bytes.size())
    return Error::input("it has " + std::to_string(png.image.width) + "x" + std::to_string(png.image.height) +
                        " cells, more than the 2^26 that a slice may have, or than its " +
                        std::to_string(bytes.size()) + " bytes can hold");
  const bool isGrey = !png.has(PNG_FORMAT_FLAG_COLOR) && !png.has(PNG_FORMAT_FLAG_ALPHA);
  return PngSlice{static_cast<std::int32_t>(png.image.width), static_cast<std::int32_t>(png.image.height),
                  isGrey};
}

Expected<void> decodePngSlice(std::span<const std::byte> bytes, const PngSlice &slice,
                              std::span<std::byte> target) {
  OpenPng png(bytes);
  if (!png.isOpen || static_cast<std::int32_t>(png.image.width) != slice.width ||
      static_cast<std::int32_t>(png.image.height) != slice.height || target.size() != slice.bytes())
    return Error::input("its header cannot be read again");
  const bool hasAlpha = png.has(PNG_FORMAT_FLAG_ALPHA);
  png.image.format = slice.isGrey ? PNG_FORMAT_GRAY : PNG_FORMAT_RGBA;
  if (!png_image_finish_read(&png.image, nullptr, target.data(), 0, nullptr))
    return Error::input(std::string("it is broken: ") + png.image.message);
  if (!slice.isGrey && !hasAlpha)
    clearBlack(target);
  return {};
}

} // namespace voxc
