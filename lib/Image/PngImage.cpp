// PNG by libpng, as texels.
#include "Image/ImageKinds.h"

#include "Image/PngReader.h"

namespace voxc {

namespace {

std::optional<ImageSize> readPngSize(std::span<const std::byte> bytes) {
  const auto png = openPng(bytes, PngForm::Texels);
  if (!png)
    return std::nullopt;
  return ImageSize{static_cast<int>((*png)->header().width), static_cast<int>((*png)->header().height)};
}

std::string decodePng(std::span<const std::byte> bytes, ImageSize size, std::uint32_t *texels) {
  const auto png = openPng(bytes, PngForm::Texels);
  if (!png)
    return png.error().message;
  const auto decoded =
      (*png)->decode(std::as_writable_bytes(std::span(texels, static_cast<std::size_t>(size.texels()))));
  return decoded ? std::string() : decoded.error().message;
}

} // namespace

const ImageKind kPngImage{[](std::span<const std::byte> bytes) { return startsWith(bytes, "\x89PNG"); },
                          readPngSize, decodePng, 0};

} // namespace voxc
