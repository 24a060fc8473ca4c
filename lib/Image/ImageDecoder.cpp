// The limits that hold for images of every kind.
#include "Image/ImageDecoder.h"

#include "Image/ImageKinds.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace voxc {

namespace {

/// A small file can claim an enormous image: 256 MiB decoded is enough for any texture.
constexpr std::int64_t kMostTexels = std::int64_t{1} << 26;
constexpr int kMostTexelsASide = 16384;

constexpr std::int64_t kFewTexels = 1 << 16;

const ImageKind &kindOf(std::span<const std::byte> bytes) {
  for (const ImageKind *kind : {&kPngImage, &kJpegImage, &kWebPImage})
    if (kind->recognises(bytes))
      return *kind;
  return kOtherImage;
}

/// What is wrong with an image of this size, or nothing.
std::string checkSize(ImageSize size, const ImageKind &kind, std::size_t bytes) {
  const std::string claim =
      "the image has " + std::to_string(size.width) + "x" + std::to_string(size.height) + " texels";
  if (std::max(size.width, size.height) > kMostTexelsASide)
    return claim + ", but none may have more than 16384 a side";
  if (size.texels() > kFewTexels + kind.mostTexelsAByte * static_cast<std::int64_t>(bytes))
    return claim + ", more than its " + std::to_string(bytes) + " bytes can hold";
  if (size.texels() > kMostTexels)
    return claim + ", but none may have more than 2^26";
  return {};
}

} // namespace

Expected<DecodedImage> ImageDecoder::decode(std::span<const std::byte> bytes) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    return Error::input("the image takes more than 2 GiB");
  const ImageKind &kind = kindOf(bytes);
  const auto size = kind.readSize(bytes);
  if (!size || size->width < 1 || size->height < 1)
    return Error::input("it is no PNG, JPEG, WebP, BMP or TGA image, or a broken one");
  if (std::string wrong = checkSize(*size, kind, bytes.size()); !wrong.empty())
    return Error::input(std::move(wrong));
  if (size->texels() > texelsLeft_)
    return Error::input("the images before it have taken all of the 2^30 texels that a model may have");
  ScratchArray<std::uint32_t> texels(memory_);
  if (auto resized = texels.resize(static_cast<std::uint64_t>(size->texels())); !resized)
    return resized.error();
  const auto decode = numbers_ == ImageNumbers::Stored && kind.decodeStored ? kind.decodeStored : kind.decode;
  if (const std::string wrong = decode(bytes, *size, texels.data()); !wrong.empty())
    return Error::input("the image is broken: " + wrong);
  texelsLeft_ -= size->texels();
  libraryPeak_ = std::max(libraryPeak_, texels.size() * kind.libraryBytesATexel);
  return DecodedImage{size->width, size->height, std::move(texels)};
}

} // namespace voxc
