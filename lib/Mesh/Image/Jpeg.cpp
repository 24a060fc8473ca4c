// JPEG through libjpeg-turbo.
#include "Mesh/Image/ImageKinds.h"

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

const unsigned char *dataOf(std::span<const std::byte> bytes) {
  return reinterpret_cast<const unsigned char *>(bytes.data());
}

struct Decompressor {
  Decompressor() : handle(tjInitDecompress()) {}
  ~Decompressor() {
    if (handle)
      tjDestroy(handle);
  }
  Decompressor(const Decompressor &) = delete;
  Decompressor &operator=(const Decompressor &) = delete;

  tjhandle handle;
};

std::optional<ImageSize> readJpegSize(std::span<const std::byte> bytes) {
  const Decompressor jpeg;
  ImageSize size;
  int subsampling = 0;
  int colours = 0;
  if (!jpeg.handle || tjDecompressHeader3(jpeg.handle, dataOf(bytes), bytes.size(), &size.width, &size.height,
                                          &subsampling, &colours) != 0)
    return std::nullopt;
  return size;
}

std::string decodeJpeg(std::span<const std::byte> bytes, ImageSize size, std::uint32_t *texels) {
  if (countScans(bytes) > kMostScans)
    return "it has more than 100 scans";
  const Decompressor jpeg;
  if (!jpeg.handle)
    return "there is no memory for it";
  const int result =
      tjDecompress2(jpeg.handle, dataOf(bytes), bytes.size(), reinterpret_cast<unsigned char *>(texels),
                    size.width, 0, size.height, TJPF_RGBA, TJFLAG_LIMITSCANS);
  // What is cut short is a warning, and shown as far as it goes.
  if (result != 0 && tjGetErrorCode(jpeg.handle) == TJERR_FATAL)
    return tjGetErrorStr2(jpeg.handle);
  return {};
}

} // namespace

const ImageKind kJpegImage{[](std::span<const std::byte> bytes) { return startsWith(bytes, "\xff\xd8\xff"); },
                           readJpegSize, decodeJpeg, 6};

} // namespace voxc
