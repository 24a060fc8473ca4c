// WebP through libwebp.
#include "Image/ImageKinds.h"

#include <webp/decode.h>

namespace voxc {

namespace {

bool isWebP(std::span<const std::byte> bytes) {
  return bytes.size() >= 12 && startsWith(bytes, "RIFF") && startsWith(bytes.subspan(8), "WEBP");
}

std::optional<ImageSize> readWebPSize(std::span<const std::byte> bytes) {
  ImageSize size;
  return WebPGetInfo(dataOf(bytes), bytes.size(), &size.width, &size.height) ? std::optional(size)
                                                                             : std::nullopt;
}

std::string decodeWebP(std::span<const std::byte> bytes, ImageSize size, std::uint32_t *texels) {
  const int stride = size.width * 4;
  const auto room = static_cast<std::size_t>(size.texels()) * 4;
  if (!WebPDecodeRGBAInto(dataOf(bytes), bytes.size(), reinterpret_cast<std::uint8_t *>(texels), room,
                          stride))
    return "libwebp cannot decode it";
  return {};
}

/// An image of one colour takes some dozens of bytes, however large it is.
constexpr std::int64_t kMostTexelsAByte = std::int64_t{1} << 19;

} // namespace

const ImageKind kWebPImage{isWebP, readWebPSize, decodeWebP, 8, kMostTexelsAByte};

} // namespace voxc
