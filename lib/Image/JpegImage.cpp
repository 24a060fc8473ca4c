// JPEG through libjpeg-turbo.
#include "Image/ImageKinds.h"

#include <turbojpeg.h>

#include <memory>

namespace voxc {

namespace {

/// A progressive JPEG is drawn in about ten scans, each of which costs the time of the whole image.
constexpr int kMostScans = 100;

int countScans(std::span<const std::byte> bytes) {
  int scans = 0;
  for (std::size_t i = 1; i < bytes.size(); ++i)
    scans += bytes[i - 1] == std::byte{0xff} && bytes[i] == std::byte{0xda};
  return scans;
}

using Decompressor = std::unique_ptr<void, int (*)(tjhandle)>;

Decompressor makeDecompressor() { return {tjInitDecompress(), tjDestroy}; }

struct Header {
  ImageSize size;
  int colours = 0; ///< Of `TJCS`.
};

std::optional<Header> readHeader(std::span<const std::byte> bytes) {
  const Decompressor jpeg = makeDecompressor();
  Header header;
  int subsampling = 0;
  if (!jpeg || tjDecompressHeader3(jpeg.get(), dataOf(bytes), bytes.size(), &header.size.width,
                                   &header.size.height, &subsampling, &header.colours) != 0)
    return std::nullopt;
  return header;
}

std::optional<ImageSize> readJpegSize(std::span<const std::byte> bytes) {
  const auto header = readHeader(bytes);
  return header ? std::optional(header->size) : std::nullopt;
}

/// Is there a segment of Adobe's before the first scan?
bool hasAdobeSegment(std::span<const std::byte> bytes) {
  constexpr std::byte kAdobe{0xee};
  constexpr std::byte kScan{0xda};
  std::size_t at = 2;
  while (at + 4 <= bytes.size() && bytes[at] == std::byte{0xff} && bytes[at + 1] != kScan) {
    if (bytes[at + 1] == std::byte{0xff}) { // Fills.
      ++at;
      continue;
    }
    if (bytes[at + 1] == kAdobe && startsWith(bytes.subspan(at + 4), "Adobe"))
      return true;
    at +=
        2 + (std::to_integer<std::size_t>(bytes[at + 2]) << 8 | std::to_integer<std::size_t>(bytes[at + 3]));
  }
  return false;
}

/// Makes RGBA of cyan, magenta, yellow and black, of which each takes away light of its own and black of all.
/// Adobe's programs store what they leave, others what they take away.
void convertInks(std::span<std::uint32_t> texels, bool areInverted) {
  const std::uint32_t flip = areInverted ? 0 : ~std::uint32_t{0};
  for (std::uint32_t &texel : texels) {
    const std::uint32_t left = texel ^ flip;
    const std::uint32_t black = left >> 24;
    const auto channel = [&](int bit) { return ((left >> bit & 255) * black + 127) / 255 << bit; };
    texel = channel(0) | channel(8) | channel(16) | 0xff000000;
  }
}

std::string decodeJpeg(std::span<const std::byte> bytes, ImageSize size, std::uint32_t *texels) {
  if (countScans(bytes) > kMostScans)
    return "it has more than 100 scans";
  const Decompressor jpeg = makeDecompressor();
  if (!jpeg)
    return "there is no memory for it";
  const auto header = readHeader(bytes);
  const bool areInks = header && (header->colours == TJCS_CMYK || header->colours == TJCS_YCCK);
  const int result =
      tjDecompress2(jpeg.get(), dataOf(bytes), bytes.size(), reinterpret_cast<unsigned char *>(texels),
                    size.width, 0, size.height, areInks ? TJPF_CMYK : TJPF_RGBA, TJFLAG_LIMITSCANS);
  // What is cut short is a warning, and shown as far as it goes.
  if (result != 0 && tjGetErrorCode(jpeg.get()) == TJERR_FATAL)
    return tjGetErrorStr2(jpeg.get());
  if (areInks)
    convertInks({texels, static_cast<std::size_t>(size.texels())}, hasAdobeSegment(bytes));
  return {};
}

} // namespace

const ImageKind kJpegImage{[](std::span<const std::byte> bytes) { return startsWith(bytes, "\xff\xd8\xff"); },
                           readJpegSize, decodeJpeg, 8};

} // namespace voxc
