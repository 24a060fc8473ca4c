// Fuzzes the decoding of images.
#include "Mesh/Image/ImageDecoder.h"
#include "SceneUse.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  voxc::ImageDecoder decoder(voxc::WorkingMemory::create(voxc::fuzz::kBound));
  const auto texture = decoder.decode({reinterpret_cast<const std::byte *>(data), size});
  if (texture)
    voxc::fuzz::require(texture->texels->size() ==
                        std::uint64_t(texture->width) * std::uint64_t(texture->height));
  return 0;
}
