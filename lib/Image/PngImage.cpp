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

template <PngForm form>
std::string decodePng(std::span<const std::byte> bytes, ImageSize size, std::uint32_t *texels) {
  const auto png = openPng(bytes, form);
  if (!png)
    return png.error().message;
  const auto decoded =
      (*png)->decode(std::as_writable_bytes(std::span(texels, static_cast<std::size_t>(size.texels()))));
  return decoded ? std::string() : decoded.error().message;
}

} // namespace

const ImageKind kPngImage{
    .recognises = [](std::span<const std::byte> bytes) { return startsWith(bytes, "\x89PNG"); },
    .readSize = readPngSize,
    .decode = decodePng<PngForm::Texels>,
    .libraryBytesATexel = 0,
    .decodeStored = decodePng<PngForm::Stored>};

} // namespace voxc
