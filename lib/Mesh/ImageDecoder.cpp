// Images through stb_image, whose code is compiled into this file alone.
#include "Mesh/ImageDecoder.h"

#include <cstring>
#include <limits>
#include <memory>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace voxc {

namespace {

/// A small file can claim an enormous image: 256 MiB decoded is enough for any texture.
constexpr std::int64_t kMaxTexels = std::int64_t{1} << 26;

} // namespace

Expected<Texture> decodeImage(std::span<const std::byte> bytes) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    return Error::input("the image takes more than 2 GiB");
  const auto *data = reinterpret_cast<const stbi_uc *>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  Texture texture;
  int channels = 0;
  if (!stbi_info_from_memory(data, size, &texture.width, &texture.height, &channels))
    return Error::input("the image is of no known kind");
  if (std::int64_t{texture.width} * texture.height > kMaxTexels)
    return Error::input("the image has " + std::to_string(texture.width) + "x" +
                        std::to_string(texture.height) + " texels, more than the 67108864 that are decoded");
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> decoded(
      stbi_load_from_memory(data, size, &texture.width, &texture.height, &channels, 4), stbi_image_free);
  if (!decoded)
    return Error::input(std::string("the image is broken: ") + stbi_failure_reason());
  texture.texels.resize(static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height));
  std::memcpy(texture.texels.data(), decoded.get(), texture.texels.size() * 4);
  return texture;
}

} // namespace voxc
