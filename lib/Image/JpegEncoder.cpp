// JPEG by libjpeg-turbo.
#include "voxc/Image/Encode.h"

#include <turbojpeg.h>

#include <memory>

namespace voxc {

Expected<std::string> encodeJpeg(std::span<const std::uint32_t> words, int width, int height, int quality) {
  // Whoever asks for the best wants the colour of each pixel.
  constexpr int kBest = 90;
  const int subsampling = quality > kBest ? TJSAMP_444 : TJSAMP_420;
  const std::unique_ptr<void, int (*)(tjhandle)> jpeg(tjInitCompress(), tjDestroy);
  unsigned char *bytes = nullptr;
  unsigned long size = 0;
  const bool isEncoded =
      jpeg && tjCompress2(jpeg.get(), reinterpret_cast<const unsigned char *>(words.data()), width, 0, height,
                          TJPF_RGBA, &bytes, &size, subsampling, quality, 0) == 0;
  const std::unique_ptr<unsigned char, void (*)(unsigned char *)> owner(bytes, tjFree);
  if (!isEncoded)
    return Error::environment(std::string("a picture cannot be encoded: ") + tjGetErrorStr2(jpeg.get()));
  return std::string(reinterpret_cast<const char *>(bytes), size);
}

} // namespace voxc
