// Fuzzes the decoding of images.
#include "Image/ImageDecoder.h"
#include "SceneUse.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  voxc::ImageDecoder decoder(voxc::WorkingMemory::create(voxc::fuzz::kBound));
  const auto image = decoder.decode({reinterpret_cast<const std::byte *>(data), size});
  if (image)
    voxc::fuzz::require(image->texels.size() == std::uint64_t(image->width) * std::uint64_t(image->height));
  return 0;
}
