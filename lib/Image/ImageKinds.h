// The kinds of images that are decoded, each by a library of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace voxc {

struct ImageSize {
  int width = 0;
  int height = 0;

  std::int64_t texels() const { return std::int64_t{width} * height; }
};

struct ImageKind {
  bool (*recognises)(std::span<const std::byte> bytes);
  /// The size that the file claims; nothing if it has no header that makes sense.
  std::optional<ImageSize> (*readSize)(std::span<const std::byte> bytes);
  /// Writes RGBA8 texels of exactly that size. What is wrong, or nothing.
  using Decode = std::string(std::span<const std::byte> bytes, ImageSize size, std::uint32_t *texels);
  Decode *decode;
  /// What the library may hold beside the texels, a texel.
  std::uint64_t libraryBytesATexel;
  /// More texels than its compression can make of a byte. (Deflate: 1032 bytes, of one bit a texel.)
  std::int64_t mostTexelsAByte = 8400;
  /// The same as `decode` whatever the image says of its gamma; null: `decode` does not ask for that.
  Decode *decodeStored = nullptr;
};

/// By libpng, row by row.
extern const ImageKind kPngImage;
/// By libjpeg-turbo, which holds the coefficients of a progressive image.
extern const ImageKind kJpegImage;
/// By libwebp.
extern const ImageKind kWebPImage;
/// By stb_image: BMP, and TGA, which no sign begins with, so that anything may be one.
extern const ImageKind kOtherImage;

inline bool startsWith(std::span<const std::byte> bytes, std::string_view sign) {
  return std::string_view(reinterpret_cast<const char *>(bytes.data()), bytes.size()).starts_with(sign);
}

inline const unsigned char *dataOf(std::span<const std::byte> bytes) {
  return reinterpret_cast<const unsigned char *>(bytes.data());
}

} // namespace voxc
