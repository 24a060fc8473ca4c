// PNG through libpng.
#include "Image/ImageKinds.h"

#include <png.h>

#include <cstring>

namespace voxc {

namespace {

/// An image whose header has been read; freed on every way out.
struct OpenPng {
  explicit OpenPng(std::span<const std::byte> bytes) {
    std::memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    isOpen = png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) != 0;
    // Colours are taken as they are, those of 16 bits too.
    image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
    image.format = PNG_FORMAT_RGBA;
  }
  ~OpenPng() { png_image_free(&image); }
  OpenPng(const OpenPng &) = delete;
  OpenPng &operator=(const OpenPng &) = delete;

  ImageSize size() const { return {static_cast<int>(image.width), static_cast<int>(image.height)}; }

  png_image image;
  bool isOpen = false;
};

std::optional<ImageSize> readPngSize(std::span<const std::byte> bytes) {
  const OpenPng png(bytes);
  return png.isOpen ? std::optional(png.size()) : std::nullopt;
}

std::string decodePng(std::span<const std::byte> bytes, ImageSize size, std::uint32_t *texels) {
  OpenPng png(bytes);
  if (!png.isOpen || png.size().width != size.width || png.size().height != size.height)
    return "its header cannot be read";
  if (!png_image_finish_read(&png.image, nullptr, texels, 0, nullptr))
    return png.image.message;
  return {};
}

} // namespace

const ImageKind kPngImage{[](std::span<const std::byte> bytes) { return startsWith(bytes, "\x89PNG"); },
                          readPngSize, decodePng, 0};

} // namespace voxc
