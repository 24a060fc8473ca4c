// PNG by libpng.
#include "voxc/Image/Encode.h"

#include <png.h>

#include <cstring>

namespace voxc {

Expected<std::string> encodePng(std::span<const std::uint32_t> words, int width, int height) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, words.data(), 0, nullptr))
    return Error::environment(std::string("a picture cannot be encoded: ") + image.message);
  bytes.resize(size);
  return bytes;
}

} // namespace voxc
